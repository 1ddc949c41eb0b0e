// The wipe between two pictures, and the magnifiers. The pictures are the page's <img data-name>.
"use strict";
(() => {
    const element = (id) => document.getElementById(id);
    const pictures = [...document.querySelectorAll("img[data-name]")];
    const renders = pictures.filter((picture) => picture.dataset.kind === "render");
    const stage = element("stage"), wipe = element("wipe"), lists = {left: element("left"), right: element("right")};
    const edges = element("edges");
    const width = edges.width, height = edges.height;
    const kAcross = 11;   // pixels that a magnifier shows, across and down
    const kZoom = 7;      // canvas pixels for each of them
    const kReach = (kAcross - 1) / 2;

    const state = {left: "fixed", right: "programmable", wipe: 50, x: width >> 1, y: height >> 1, held: false};
    const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
    const named = (name) => pictures.find((picture) => picture.dataset.name === name);

    // The address holds the state, so that a view can be shared: #left=fixed&right=reference&wipe=30&pixel=3,4
    const read_address = () => {
        const values = new URLSearchParams(location.hash.slice(1));
        for (const side of ["left", "right"]) if (named(values.get(side))) state[side] = values.get(side);
        if (values.has("wipe")) state.wipe = clamp(Number(values.get("wipe")) || 0, 0, 100);
        const pixel = (values.get("pixel") ?? "").split(",").map(Number);
        if (pixel.length === 2 && pixel.every(Number.isInteger)) {
            [state.x, state.y, state.held] = [clamp(pixel[0], 0, width - 1), clamp(pixel[1], 0, height - 1), true];
        }
    };
    const write_address = () => {
        const values = new URLSearchParams({left: state.left, right: state.right, wipe: state.wipe});
        if (state.held) values.set("pixel", state.x + "," + state.y);
        history.replaceState(null, "", "#" + values);
    };

    // ---- The wipe ----
    for (const list of Object.values(lists)) {
        for (const [kind, label] of [["render", "Pictures"], ["difference", "Differences"]]) {
            const group = list.appendChild(document.createElement("optgroup"));
            group.label = label;
            for (const picture of pictures.filter((p) => p.dataset.kind === kind)) {
                group.append(new Option(picture.dataset.name, picture.dataset.name));
            }
        }
    }
    const show_wipe = () => {
        for (const side of ["left", "right"]) {
            lists[side].value = state[side];
            element(side + "-picture").src = named(state[side]).src;
        }
        wipe.value = state.wipe;
        wipe.setAttribute("aria-valuetext", Math.round(state.wipe) + " % " + state.left);
        element("right-picture").style.clipPath = "inset(0 0 0 " + state.wipe + "%)";
        element("border").style.left = state.wipe + "%";
    };
    const set_wipe = (value) => {
        state.wipe = clamp(value, 0, 100);
        show_wipe();
    };
    for (const side of ["left", "right"]) {
        lists[side].addEventListener("change", () => {
            state[side] = lists[side].value;
            show_wipe();
            write_address();
        });
    }
    wipe.addEventListener("input", () => set_wipe(Number(wipe.value)));
    wipe.addEventListener("change", write_address);
    const border = element("border");
    border.addEventListener("pointerdown", (event) => border.setPointerCapture(event.pointerId));
    border.addEventListener("pointermove", (event) => {
        if (!border.hasPointerCapture(event.pointerId)) return;
        const box = stage.getBoundingClientRect();
        set_wipe(Math.round((event.clientX - box.left) / box.width * 200) / 2);
    });
    border.addEventListener("pointerup", write_address);
    border.addEventListener("click", (event) => event.stopPropagation());
    element("show-edges").addEventListener("change", (event) => {
        element("edge-picture").hidden = !event.target.checked;
    });

    // ---- The magnifiers ----
    const one_pixel = document.createElement("canvas").getContext("2d", {willReadFrequently: true});
    one_pixel.canvas.width = one_pixel.canvas.height = 1;
    const values_at = (picture, x, y) => {
        one_pixel.drawImage(picture, x, y, 1, 1, 0, 0, 1, 1);
        return [...one_pixel.getImageData(0, 0, 1, 1).data.slice(0, 3)];
    };
    const magnifiers = renders.map((picture) => {
        const box = element("magnifiers").appendChild(document.createElement("div"));
        box.className = "magnifier";
        const canvas = box.appendChild(document.createElement("canvas"));
        canvas.width = canvas.height = kAcross * kZoom;
        const text = box.appendChild(document.createElement("div"));
        text.append(picture.dataset.name);
        return {picture, context: canvas.getContext("2d"), output: text.appendChild(document.createElement("output"))};
    });
    const show_pixel = () => {
        const {x, y} = state;
        const kind = values_at(edges, x, y)[0] > 127 ? "at an edge" : "away from edges";
        element("pixel").innerHTML = `Pixel ${x}, ${y} <span>${kind}${state.held ? ", selected" : ""}</span>`;
        for (const {picture, context, output} of magnifiers) {
            context.imageSmoothingEnabled = false;
            context.fillStyle = "#808080";
            context.fillRect(0, 0, context.canvas.width, context.canvas.height);
            context.drawImage(picture, x - kReach, y - kReach, kAcross, kAcross, 0, 0, kAcross * kZoom, kAcross * kZoom);
            context.lineWidth = 1;
            for (const [color, grow] of [["#000", 1.5], ["#fff", .5]]) {
                context.strokeStyle = color;
                const start = kReach * kZoom - grow, side = kZoom + 2 * grow;
                context.strokeRect(start, start, side, side);
            }
            output.value = values_at(picture, x, y).map((value) => String(value).padStart(3)).join(" ");
        }
        Object.assign(element("marker").style, {
            left: x / width * 100 + "%", top: y / height * 100 + "%",
            width: 100 / width + "%", height: 100 / height + "%",
        });
    };
    const set_pixel = (x, y) => {
        [state.x, state.y] = [clamp(x, 0, width - 1), clamp(y, 0, height - 1)];
        show_pixel();
    };
    const set_pixel_under = (event) => {
        const box = stage.getBoundingClientRect();
        set_pixel(Math.floor((event.clientX - box.left) / box.width * width),
                  Math.floor((event.clientY - box.top) / box.height * height));
    };
    const hold = (held) => {
        state.held = held;
        show_pixel();
        write_address();
    };
    stage.addEventListener("pointermove", (event) => {
        if (!state.held) set_pixel_under(event);
    });
    stage.addEventListener("click", (event) => {
        if (!state.held) set_pixel_under(event);
        hold(!state.held);
    });
    stage.addEventListener("keydown", (event) => {
        const step = event.shiftKey ? 10 : 1;
        const move = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
        if (move) {
            set_pixel(state.x + move[0] * step, state.y + move[1] * step);
            hold(true);
            event.preventDefault();
        } else if (event.key === "Escape") {
            hold(false);
        }
    });
    for (const button of document.querySelectorAll("button.place")) {
        button.addEventListener("click", () => {
            set_pixel(Number(button.dataset.x), Number(button.dataset.y));
            hold(true);
            element("wipe-section").scrollIntoView();
            stage.focus({preventScroll: true});   // so that the arrow keys start from this pixel
        });
    }

    // ---- Size: small pictures are enlarged by a whole factor, large ones fill the page ----
    const fit = () => {
        const room = element("wipe-section").clientWidth;
        const beside = room > 900 ? room - 270 : room;
        const shown = width > beside ? beside : width * Math.floor(beside / width);
        stage.style.width = shown + "px";
        stage.style.aspectRatio = width + " / " + height;
    };
    addEventListener("resize", fit);
    addEventListener("hashchange", () => {
        read_address();
        show_wipe();
        show_pixel();
    });

    document.documentElement.classList.add("with-script");
    element("edge-picture").src = edges.src;
    read_address();
    fit();
    show_wipe();
    Promise.all([edges, ...pictures].map((picture) => picture.decode())).then(show_pixel);
})();
