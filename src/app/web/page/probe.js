// The probe: bars and a table of the lighting's terms at a pixel, and the vectors there in each picture.
import {element, termBars, termTable} from "./terms.js";

const at = (id) => document.getElementById(id);
const SVG = "http://www.w3.org/2000/svg";
function drawn(kind, attributes) {
    const made = document.createElementNS(SVG, kind);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
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
    at("terms").replaceChildren(...(rows.length > 0 ? [element("h2", heading), termBars(rows), termTable(rows)] : []),
        ...(mean.length > 0 ? [element("h2", "The pixel: a mean of its vertices"), termTable(mean)] : []));
    showArrows(arrows, size);
}

export const hideArrows = () => document.querySelectorAll("svg.arrows").forEach((svg) => svg.replaceChildren());
