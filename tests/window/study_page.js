// Uses the study's page as a reader would, and leaves in its place one object that tells what came of it (study_page_test.cpp).
"use strict";
(async () => {
    const pause = () => new Promise((done) => setTimeout(done, 150));
    const element = (id) => document.getElementById(id);
    const told = {};
    const canvas = element("chart"), chart = Chart.getChart(canvas);
    const until = async (is_so, attempt = () => {}) => {
        for (let tries = 0; tries < 50 && !is_so(); ++tries) {
            attempt();
            await pause();
        }
    };
    const point_at = (number) => {
        canvas.scrollIntoView();
        const dot = chart.getDatasetMeta(0).data[number], box = canvas.getBoundingClientRect();
        const place = {clientX: box.left + dot.x, clientY: box.top + dot.y, bubbles: true};
        canvas.dispatchEvent(new MouseEvent("mousemove", place));
    };
    const press = async (key) => {
        canvas.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true}));
        await pause();
    };
    const set = async (id, value, event) => {
        element(id).value = value;
        element(id).dispatchEvent(new Event(event, {bubbles: true}));
        await pause();
    };
    const slide = (id, value) => set(id, value, "input");
    const choose = (id, value) => set(id, value, "change");
    const column = (n) => [...document.querySelectorAll("#points tbody tr")].map((row) => row.cells[n].textContent);
    try {
        await pause();
        told.dots = chart.data.datasets[0].data.length;
        told.hidden_at_first = element("detail").hidden;
        // Events wait for the next picture, and the plot may not have its size yet.
        const name = chart.data.datasets[0].data[3].point.words;
        await until(() => element("detail-name").textContent.startsWith(name), () => point_at(3));
        await until(() => element("detail-picture").complete && element("detail-difference").complete);
        told.pointed_at = element("detail-name").textContent;
        told.picture = [element("detail-picture").naturalWidth, element("detail-picture").offsetWidth > 0];
        told.difference = element("detail-difference").naturalWidth;
        const here = element("detail-name").textContent;
        await press("ArrowDown");
        await press("ArrowDown");
        told.key_moves = [here, element("detail-name").textContent];

        await slide("target", 900);
        told.rough = [element("target-value").textContent, element("target-choice").textContent];
        await slide("target", 100);
        told.fine = [element("target-value").textContent, element("target-choice").textContent];
        await slide("wipe", 25);
        told.wiped = element("truth").style.clipPath;

        const time = document.querySelector("#points").dataset.time;
        told.unsorted = column(time);
        document.querySelectorAll("#points thead button")[time].click();
        told.rising = column(time);
        document.querySelectorAll("#points thead button")[time].click();
        told.falling = column(time);

        const first = document.querySelector("#filters input");
        first.click();
        await pause();
        told.dots_filtered = chart.data.datasets[0].data.length;
        told.rows_filtered = document.querySelectorAll("#points tbody tr:not([hidden])").length;
        first.click();

        told.measures = [];
        for (const option of element("measure").options) {
            await choose("measure", option.value);
            told.measures.push(chart.options.scales.y.title.text);
        }
        await choose("region", "silhouette");
        await choose("colour", "shading");
        told.legend = element("legend").textContent;
        told.orders = Chart.getChart(element("convergence")).data.datasets.map((line) => line.label);
    } catch (error) {
        complaints.push(String(error.stack));
    }
    told.complaints = complaints;
    document.body.replaceChildren(Object.assign(document.createElement("pre"), {textContent: "told:" + JSON.stringify(told) + ":told"}));
})();
