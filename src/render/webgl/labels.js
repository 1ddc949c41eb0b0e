// Texts over a picture, where the scene has #pragma twinlight label.
const MARGIN_PX = 4;

// Each is centred at its point, but inside the picture. As in the window, one that would cover an earlier one is left out.
function place(layer) {
    const shown = [];
    for (const label of layer.children) {
        const {offsetWidth: width, offsetHeight: height} = label, most = layer.clientWidth - MARGIN_PX - width;
        const left = Math.max(MARGIN_PX, Math.min(most, label.dataset.x * layer.clientWidth - width / 2));
        const top = Math.max(0, Math.min(layer.clientHeight - height, label.dataset.y * layer.clientHeight - height / 2));
        const covers = (other) => left < other.left + other.width + MARGIN_PX && other.left < left + width + MARGIN_PX &&
            top < other.top + other.height && other.top < top + height;
        [label.style.left, label.style.top] = [`${left}px`, `${top}px`];
        label.style.visibility = most < MARGIN_PX || shown.some(covers) ? "hidden" : "visible";
        if (label.style.visibility === "visible") shown.push({left, top, width, height});
    }
}

// labels: [{text, at: [x, y]}], in pixels of the picture from its upper left corner. The canvas is the last thing in its element, which is
// as wide, and gets them.
export function showLabels(canvas, labels, {width, height}) {
    let layer = canvas.parentElement.querySelector(".labels");
    if (!layer) {
        layer = canvas.parentElement.appendChild(document.createElement("div"));
        layer.className = "labels";
        new ResizeObserver(() => place(layer)).observe(layer);
    }
    layer.style.aspectRatio = `${width} / ${height}`;
    layer.replaceChildren(...labels.map(({text, at: [x, y]}) => {
        const label = document.createElement("span");
        label.textContent = text;
        [label.dataset.x, label.dataset.y] = [x / width, y / height];
        return label;
    }));
    place(layer);
}
