"use strict";
(function () {
    document.documentElement.classList.add("with-script");
    const rows = Array.from(document.querySelectorAll("#points tbody tr"));
    const dots = new Map();
    for (const dot of document.querySelectorAll("svg .dot")) dots.set(dot.dataset.point, dot);
    const element = (id) => document.getElementById(id);

    function show(number) {
        const row = rows.find((r) => r.dataset.point === number);
        if (!row) return;
        for (const r of rows) r.classList.toggle("chosen", r === row);
        for (const [key, dot] of dots) dot.classList.toggle("chosen", key === number);
        element("detail").hidden = false;
        element("detail-name").textContent = row.cells[0].textContent + ": " + row.cells[1].textContent + " ms, rms " +
            row.cells[3].textContent;
        element("detail-picture").src = row.dataset.picture;
        element("detail-difference").src = row.dataset.difference;
        element("detail-factor").textContent = "\u00d7 " + row.dataset.factor;
    }

    for (const [number, dot] of dots) {
        dot.setAttribute("tabindex", "0");
        for (const event of ["pointerenter", "focus", "click"]) dot.addEventListener(event, () => show(number));
    }
    for (const row of rows) {
        row.tabIndex = 0;
        for (const event of ["click", "focus"]) row.addEventListener(event, () => show(row.dataset.point));
    }

    const table = element("points");
    Array.from(table.tHead.rows[0].cells).forEach((head, column) => {
        const button = document.createElement("button");
        button.type = "button";
        button.className = "place";
        button.textContent = head.textContent;
        button.title = "sort by this column";
        head.replaceChildren(button);
        let sign = -1;
        button.addEventListener("click", () => {
            sign = -sign;
            const value = (row) => {
                const text = row.cells[column].textContent;
                const number = Number.parseFloat(text);
                return Number.isNaN(number) || column === 0 ? text : number;
            };
            const sorted = rows.slice().sort((a, b) => {
                const x = value(a), y = value(b);
                if (typeof x === "number" && typeof y === "number") return sign * (x - y);
                return sign * String(x).localeCompare(String(y));
            });
            table.tBodies[0].append(...sorted);
        });
    });
})();
