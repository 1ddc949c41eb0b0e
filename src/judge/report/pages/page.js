// The wipe between two pictures, the magnifiers, and the steps of a scene. Each article.comparison is a view of its own; its
// pictures are its <img data-name>.
"use strict";
(() => {
    const kAcross = 11;   // pixels that a magnifier shows, across and down
    const kZoom = 7;      // canvas pixels for each of them
    const kReach = (kAcross - 1) / 2;
    const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

    const one_pixel = document.createElement("canvas").getContext("2d", {willReadFrequently: true});
    one_pixel.canvas.width = one_pixel.canvas.height = 1;
    const values_at = (picture, x, y) => {
        one_pixel.drawImage(picture, x, y, 1, 1, 0, 0, 1, 1);
        return [...one_pixel.getImageData(0, 0, 1, 1).data.slice(0, 3)];
    };

    // The script of one article. `changed` is called when the address should be written.
    function view(article, changed) {
        const element = (name) => article.querySelector("." + name);
        const pictures = [...article.querySelectorAll("img[data-name]")];
        const renders = pictures.filter((picture) => picture.dataset.kind === "render");
        const stage = element("stage"), wipe = element("wipe"), border = element("border");
        const lists = {left: element("left"), right: element("right")};
        const shown_pairs = [...element("pairs").children];
        const edges = element("edges"), why = element("why");
        const whys = why.dataset.words.split("|");
        const width = edges.width, height = edges.height;
        const {left, right} = shown_pairs[0].dataset;
        const state = {left, right, wipe: 50, held: false, x: Number(article.dataset.x), y: Number(article.dataset.y)};
        const named = (name) => pictures.find((picture) => picture.dataset.name === name);

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
            border.style.left = state.wipe + "%";
            const is_shown = (pair) => pair.dataset.left === state.left && pair.dataset.right === state.right;
            for (const pair of shown_pairs) pair.setAttribute("aria-pressed", is_shown(pair));
            element("says").textContent = shown_pairs.find(is_shown)?.dataset.says ?? `Left: ${state.left}. Right: ${state.right}.`;
        };
        const set_wipe = (value) => {
            state.wipe = clamp(value, 0, 100);
            show_wipe();
        };
        const show_pair = (left, right) => {
            [state.left, state.right] = [left, right];
            show_wipe();
            changed();
        };
        for (const pair of shown_pairs) pair.addEventListener("click", () => show_pair(pair.dataset.left, pair.dataset.right));
        for (const list of Object.values(lists)) {
            list.addEventListener("change", () => show_pair(lists.left.value, lists.right.value));
        }
        wipe.addEventListener("input", () => set_wipe(Number(wipe.value)));
        wipe.addEventListener("change", changed);
        border.addEventListener("pointerdown", (event) => border.setPointerCapture(event.pointerId));
        border.addEventListener("pointermove", (event) => {
            if (!border.hasPointerCapture(event.pointerId)) return;
            const box = stage.getBoundingClientRect();
            set_wipe(Math.round((event.clientX - box.left) / box.width * 200) / 2);
        });
        border.addEventListener("pointerup", changed);
        border.addEventListener("click", (event) => event.stopPropagation());
        element("show-edges").addEventListener("change", (event) => {
            element("edge-picture").hidden = !event.target.checked;
        });

        element("show-labels")?.addEventListener("change", (event) => {
            element("scene-labels").hidden = !event.target.checked;
        });

        // ---- The magnifiers ----
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
            const [low, middle, high] = values_at(why, x, y), bits = low + 256 * middle + 65536 * high;
            const reasons = whys.filter((_, bit) => bits >> bit & 1);
            const is_edge = values_at(edges, x, y)[0] > 127;
            const kind = is_edge
                ? "at an edge" + (reasons.length > 0 ? ": " + reasons.join("; ") : "")
                : "away from edges" + (reasons.length > 0 ? "; a channel may be off: " + reasons.join(", ") : "");
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
            changed();
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
        for (const button of article.querySelectorAll("button.place")) {
            button.addEventListener("click", () => {
                set_pixel(Number(button.dataset.x), Number(button.dataset.y));
                hold(true);
                element("view").scrollIntoView();
                stage.focus({preventScroll: true});   // so that the arrow keys start from this pixel
            });
        }

        // Small pictures are enlarged by a whole factor, large ones fill the page.
        const fit = () => {
            const room = element("view").clientWidth;
            const beside = room > 900 ? room - 270 : room;
            const shown = width > beside ? beside : width * Math.floor(beside / width);
            stage.style.width = shown + "px";
            stage.style.aspectRatio = width + " / " + height;
        };

        element("edge-picture").src = edges.src;
        const decoded = Promise.all([edges, why, ...pictures].map((picture) => picture.decode()));
        return {
            article,
            thumbnail: () => Object.assign(new Image(), {src: renders[0].src, alt: ""}),
            read(values) {
                for (const side of ["left", "right"]) if (named(values.get(side))) state[side] = values.get(side);
                if (values.has("wipe")) state.wipe = clamp(Number(values.get("wipe")) || 0, 0, 100);
                const pixel = (values.get("pixel") ?? "").split(",").map(Number);
                if (pixel.length === 2 && pixel.every(Number.isInteger)) {
                    [state.x, state.y, state.held] = [clamp(pixel[0], 0, width - 1), clamp(pixel[1], 0, height - 1), true];
                }
            },
            write(values) {
                for (const name of ["left", "right", "wipe"]) values.set(name, state[name]);
                if (state.held) values.set("pixel", state.x + "," + state.y);
            },
            fit,
            show() {
                fit();
                show_wipe();
                decoded.then(show_pixel);
            },
        };
    }

    // ---- The steps, and the address, so that a view can be shared: #step=2&left=fixed&right=reference&wipe=30&pixel=3,4 ----
    const tabs = [...document.querySelectorAll("nav.steps a")];
    let current = 0;
    const write_address = () => {
        const values = new URLSearchParams(tabs.length > 0 ? {step: current + 1} : {});
        views[current].write(values);
        history.replaceState(null, "", "#" + values);
    };
    const views = [...document.querySelectorAll("article.comparison")].map((article) => view(article, write_address));
    tabs.forEach((tab, number) => tab.prepend(views[number].thumbnail()));
    // Without the script, the links of the steps lead to these ids; with it, the page must not jump there.
    for (const one of views) one.article.removeAttribute("id");
    const read_address = () => {
        const values = new URLSearchParams(location.hash.slice(1));
        current = clamp((Number.parseInt(values.get("step"), 10) || 1) - 1, 0, views.length - 1);
        views[current].read(values);
        views.forEach((one, number) => { one.article.hidden = number !== current; });
        tabs.forEach((tab, number) => {
            if (number === current) tab.setAttribute("aria-current", "true");
            else tab.removeAttribute("aria-current");
        });
        views[current].show();
    };

    document.documentElement.classList.add("with-script");
    addEventListener("resize", () => views[current].fit());
    addEventListener("hashchange", read_address);
    read_address();
})();
