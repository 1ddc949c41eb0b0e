// The probe: bars and a table of the lighting's terms at a pixel, and the vectors there in each picture.

const at = (id) => document.getElementById(id);
const SVG = "http://www.w3.org/2000/svg";
const CHANNELS = ["red", "green", "blue"];

function element(kind, text = "", className = "") {
    const made = document.createElement(kind);
    made.textContent = text;
    if (className) made.className = className;
    return made;
}
function drawn(kind, attributes) {
    const made = document.createElementNS(SVG, kind);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    return made;
}

// A bar for a channel: the terms one after the other, with a line at 1, where the sum is clamped.
function bar(rows, channel, most) {
    const made = element("div", "", CHANNELS[channel]);
    for (const {what, color} of rows) {
        const term = element("i"), value = Math.max(color[channel], 0);
        term.style.width = 100 * value / most + "%";
        term.title = `${what}: ${value.toFixed(4)}`;
        made.append(term);
    }
    made.style.setProperty("--one", 100 / most + "%");
    return made;
}

function table(rows) {
    const made = element("table");
    const head = made.createTHead().insertRow();
    for (const text of ["", "", "term", ...CHANNELS]) head.append(element(text ? "th" : "td", text));
    for (const {sign, what, how, color, is_result} of rows) {
        const row = made.insertRow(), swatch = element("span", "", "swatch");
        row.className = is_result ? "result" : "";
        swatch.style.background = `rgb(${color.map((value) => Math.round(255 * Math.min(Math.max(value, 0), 1)))})`;
        row.insertCell().textContent = sign;
        row.insertCell().append(swatch);
        row.insertCell().append(what, ...(how ? [" ", element("small", how)] : []));
        for (const value of color) row.append(element("td", value.toFixed(4), value > 1 || value < 0 ? "clipped" : ""));
    }
    return made;
}

// Points from `from` to `to`, with its name at the tip.
function arrow({kind, name, from, to}) {
    const made = drawn("g", {class: kind}), [dx, dy] = [to[0] - from[0], to[1] - from[1]], length = Math.hypot(dx, dy) || 1;
    const [ux, uy] = [dx / length, dy / length], head = Math.min(10, length / 2);
    const side = (sign) => `${to[0] - head * ux - sign * head * uy / 2},${to[1] - head * uy + sign * head * ux / 2}`;
    for (const halo of [true, false]) {
        const given = {class: halo ? "halo" : "", d: `M${from} L${to} M${side(1)} L${to} L${side(-1)}`};
        made.append(drawn("path", given));
    }
    const label = drawn("text", {x: to[0] + 10 * ux, y: to[1] + 10 * uy});
    label.textContent = name;
    made.append(label);
    return made;
}

function showArrows(arrows, {width, height}) {
    for (const canvas of document.querySelectorAll("figure canvas")) {
        const figure = canvas.parentElement, svg = figure.querySelector("svg.arrows") ?? figure.appendChild(drawn("svg", {class: "arrows", "aria-hidden": true}));
        svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
        svg.style.aspectRatio = `${width} / ${height}`;
        svg.replaceChildren(...arrows.map(arrow));
    }
}

// `probed`: what twinlight.probe() answers.
export function showProbe({heading, rows, mean, arrows}, size) {
    const terms = rows.slice(0, Math.max(rows.findIndex(({is_result}) => is_result), 0));
    const most = Math.max(1, ...[0, 1, 2].map((c) => terms.reduce((sum, {color}) => sum + Math.max(color[c], 0), 0)));
    const bars = element("div", "", "bars");
    bars.append(...CHANNELS.map((_, channel) => bar(terms, channel, most)));
    bars.ariaHidden = "true";  // the table has the numbers
    at("terms").replaceChildren(...(rows.length > 0 ? [element("h2", heading), bars, table(rows)] : []),
        ...(mean.length > 0 ? [element("h2", "The pixel: a mean of its vertices"), table(mean)] : []));
    showArrows(arrows, size);
}

export const hideArrows = () => document.querySelectorAll("svg.arrows").forEach((svg) => svg.replaceChildren());
