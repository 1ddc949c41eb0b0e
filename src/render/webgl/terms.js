// Colours that add up, as bars and as a table: the terms of the lighting at a point.

const CHANNELS = ["red", "green", "blue"];

export function element(kind, text = "", className = "") {
    const made = document.createElement(kind);
    made.textContent = text;
    if (className) made.className = className;
    return made;
}

// A bar for a channel: the terms one after the other, with a line at 1, where the sum is clamped.
function bar(terms, channel, most) {
    const made = element("div", "", CHANNELS[channel]);
    for (const {what, color} of terms) {
        const term = element("i"), value = Math.max(color[channel], 0);
        term.style.width = 100 * value / most + "%";
        term.title = `${what}: ${value.toFixed(4)}`;
        made.append(term);
    }
    made.style.setProperty("--one", 100 / most + "%");
    return made;
}

// rows: [{sign, what, how, color, is_result}], for each term, then for the results.
export function termBars(rows) {
    const terms = rows.slice(0, Math.max(rows.findIndex(({is_result}) => is_result), 0));
    const most = Math.max(1, ...[0, 1, 2].map((c) => terms.reduce((sum, {color}) => sum + Math.max(color[c], 0), 0)));
    const bars = element("div", "", "bars");
    bars.append(...CHANNELS.map((_, channel) => bar(terms, channel, most)));
    bars.ariaHidden = "true";  // the table has the numbers
    return bars;
}

export function termTable(rows, digits = 4) {
    const made = element("table"), head = made.createTHead().insertRow(), body = made.createTBody();
    for (const text of ["", "", "term", ...CHANNELS]) head.append(element(text ? "th" : "td", text));
    for (const {sign, what, how, color, is_result} of rows) {
        const row = body.insertRow(), swatch = element("span", "", "swatch");
        row.className = is_result ? "result" : "";
        swatch.style.background = `rgb(${color.map((value) => Math.round(255 * Math.min(Math.max(value, 0), 1)))})`;
        row.insertCell().textContent = sign;
        row.insertCell().append(swatch);
        row.insertCell().append(what, ...(how ? [" ", element("small", how)] : []));
        for (const value of color) row.append(element("td", value.toFixed(digits), value > 1 || value < 0 ? "clipped" : ""));
    }
    return made;
}
