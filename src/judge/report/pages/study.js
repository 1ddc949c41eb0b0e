// The plots and the table of a study, and the pictures of the selected choice. The data is the object in #study.
"use strict";
(() => {
    document.documentElement.classList.add("with-script");
    const element = (id) => document.getElementById(id);
    const study = JSON.parse(element("study").textContent);
    const points = study.points.filter((point) => point.seconds.median !== null);
    points.forEach((point) => { point.number = study.points.indexOf(point); });
    const severalMachines = study.series.length > 1;
    const state = {chosen: null, target: null, hidden: new Map()};

    // ---- Colours that are safe for colour blindness (Okabe and Ito, 2008), and a mark for each shading ----

    const kLight = ["#d55e00", "#0072b2", "#56b4e9", "#cc79a7", "#009e73", "#e69f00", "#000000", "#8a8a8a"];
    const kDark = ["#f0813a", "#4fa3e0", "#9bd3f5", "#e49cc5", "#3fc99b", "#f5b83d", "#ffffff", "#9a9a9a"];
    const kMarks = {flat: "rect", gouraud: "triangle", phong: "circle", exact: "rectRot"};
    const kSigns = {flat: "\u25a0", gouraud: "\u25b2", phong: "\u25cf", exact: "\u25c6"};
    const dark = window.matchMedia("(prefers-color-scheme: dark)");
    const palette = () => dark.matches ? kDark : kLight;
    const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

    // Colours distinguish the values of an axis, or the machines.
    const group = (point, by) => by === "series" ? study.series[point.series].name : point.values[by];
    const groups = (by) => [...new Set(points.map((point) => group(point, by)))];
    const colour = (point) => palette()[groups(element("colour").value).indexOf(group(point, element("colour").value)) % kLight.length];
    // Drawn in the usual way, without changes to the scene.
    const usual = (point) => Object.keys(point.axes).every((axis) =>
        ["renderer", "shading", "slices"].includes(axis) || point.axes[axis] === study.points[0].axes[axis]);

    const numeral = (value) => value !== 0 && (value < 1e-3 || value >= 1e4) ? Number(value.toPrecision(2)).toExponential() : String(Number(value.toPrecision(3)));
    const milliseconds = (point) => 1000 * point.seconds.median;
    const measure = () => study.measures.find((one) => one.name === element("measure").value);
    const error = (point, region = element("region").value) => point.error[region][measure().name];
    const visible = () => points.filter((point) => study.axes.every(
        (axis) => !(state.hidden.get(axis.name) ?? new Set()).has(point.values[axis.name])));
    const name = (point) => (severalMachines ? study.series[point.series].name + ": " : "") + point.words;
    const described = (point) => `${name(point)} (${numeral(milliseconds(point))} ms, ${measure().unit} ${numeral(error(point))})`;

    // The choices of a machine for which no other is both as fast and as accurate, to half a percent.
    const front = (series) => {
        let least = Infinity;
        return visible().filter((point) => point.series === series)
            .sort((a, b) => milliseconds(a) - milliseconds(b) || error(a) - error(b))
            .filter((point) => error(point) < 0.995 * least && ((least = error(point)), true));
    };

    // ---- Plots ----

    Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
    Chart.defaults.font.size = 13;

    const axis = (title) => ({
        type: "logarithmic",
        title: {display: true, text: title, color: css("--ink")},
        grid: {color: css("--line")},
        ticks: {
            color: css("--quiet"), maxRotation: 0, autoSkip: false,
            callback(value) {
                const decade = 10 ** Math.floor(Math.log10(value) + 1e-9), lead = Number((value / decade).toFixed(6));
                const wide = this.max / this.min > 300;
                return lead === 1 || (!wide && (lead === 2 || lead === 5)) ? numeral(value) : null;
            },
        },
    });
    // The range of the data, with a margin.
    const limits = (values) => values.length === 0 ? {} : {min: Math.min(...values) / 1.3, max: Math.max(...values) * 1.3};
    const motionless = {animation: false, responsive: true, maintainAspectRatio: false};

    const dotsOf = () => visible().filter((point) => error(point) > 0)
        .map((point) => ({x: milliseconds(point), y: error(point), point}));
    const line = (data, options) => ({type: "line", data, pointRadius: 0, pointHitRadius: 0, borderWidth: 1.5, ...options});

    // Chart.js repeats the last event whenever it draws. A resting pointer must not undo what the arrow keys select.
    let handled = null;
    function pointAt(event, found) {
        if (event.native === handled) return;
        handled = event.native;
        if (found.length) show(chart.data.datasets[found[0].datasetIndex].data[found[0].index].point);
    }

    const chart = new Chart(element("chart"), {
        type: "scatter",
        data: {datasets: []},
        options: {
            ...motionless,
            interaction: {mode: "nearest", intersect: true},
            onHover: pointAt,
            onClick: pointAt,
            plugins: {
                legend: {display: false},
                tooltip: {filter: (item) => item.raw.point !== undefined, callbacks: {label: (item) => described(item.raw.point)}},
            },
        },
    });

    function drawChart() {
        const dots = dotsOf(), ink = css("--ink");
        const chosen = (context) => context.raw?.point === state.chosen;
        const dataset = {
            data: dots, pointHitRadius: 6,
            pointStyle: (context) => kMarks[context.raw?.point.axes.shading] ?? "circle",
            pointRadius: (context) => chosen(context) ? 9 : 5.5,
            pointHoverRadius: 9,
            pointBackgroundColor: (context) => context.raw && usual(context.raw.point) ? colour(context.raw.point) : css("--raised"),
            pointBorderColor: (context) => !context.raw ? ink : chosen(context) ? ink : colour(context.raw.point),
            pointBorderWidth: (context) => chosen(context) ? 2.5 : 1.5,
        };
        const fronts = study.series.map((_, series) => line(
            front(series).filter((point) => error(point) > 0).map((point) => ({x: milliseconds(point), y: error(point)})),
            {borderColor: severalMachines && element("colour").value === "series" ? palette()[series] : css("--quiet"), borderDash: [4, 3]}));
        const x = limits(dots.map((dot) => dot.x)), y = limits(dots.map((dot) => dot.y));
        const target = state.target === null || dots.length === 0 ? [] : [line(
            [{x: x.min, y: state.target}, {x: x.max, y: state.target}], {borderColor: css("--accent"), borderWidth: 1})];
        chart.data.datasets = [dataset, ...fronts, ...target];
        chart.options.scales = {x: {...axis("time of a frame, ms"), ...x}, y: {...axis(measure().words), ...y}};
        chart.update("none");
        const without = visible().filter((point) => error(point) === 0);
        element("without").textContent = without.length === 0 ? "" :
            "Not in the plot, because their error is 0: " + without.map((point) => described(point)).join("; ") + ".";
    }

    const convergence = new Chart(element("convergence"), {
        type: "line", data: {datasets: []},
        options: {...motionless, plugins: {legend: {labels: {usePointStyle: true}}}},
    });

    // The slope of log y over log x, by least squares.
    function order(dots) {
        const xs = dots.map((dot) => Math.log(dot.x)), ys = dots.map((dot) => Math.log(dot.y));
        const mean = (values) => values.reduce((a, b) => a + b, 0) / values.length;
        const [mx, my] = [mean(xs), mean(ys)];
        return xs.reduce((sum, x, i) => sum + (x - mx) * (ys[i] - my), 0) / xs.reduce((sum, x) => sum + (x - mx) ** 2, 0);
    }

    function drawConvergence() {
        const region = element("convergence-region").value;
        const lines = new Map();
        for (const point of points) {
            if (point.axes.slices === null || !usual(point) || point.values.renderer !== element("renderer").value) continue;
            if (!(error(point, region) > 0)) continue;
            const key = point.series + point.axes.shading;
            if (!lines.has(key)) lines.set(key, {shading: point.axes.shading, series: point.series, dots: []});
            lines.get(key).dots.push({x: point.axes.slices, y: error(point, region)});
        }
        const shadings = Object.keys(kMarks);
        convergence.data.datasets = [...lines.values()].map(({shading, series, dots}) => {
            dots.sort((a, b) => a.x - b.x);
            const paint = palette()[(severalMachines ? series : shadings.indexOf(shading)) % kLight.length];
            const label = (severalMachines ? study.series[series].name + ", " : "") + shading +
                (dots.length > 1 ? `: order ${(-order(dots)).toFixed(1)}` : "");
            return {label, data: dots, borderColor: paint, backgroundColor: paint, borderWidth: 1.5, pointRadius: 5,
                pointStyle: kMarks[shading], pointHitRadius: 6};
        });
        const all = convergence.data.datasets.flatMap((dataset) => dataset.data);
        element("convergence-section").hidden = points.every((point) => point.axes.slices === null);
        convergence.options.plugins.legend.labels.color = css("--ink");
        convergence.options.scales = {
            x: {...axis("slices of a round shape"), ...limits(all.map((dot) => dot.x))},
            y: {...axis(measure().words), ...limits(all.map((dot) => dot.y))},
        };
        convergence.options.scales.x.ticks.callback = (value) => all.some((dot) => dot.x === value) ? value : null;
        convergence.options.scales.x.afterBuildTicks = (scale) => {
            scale.ticks = [...new Set(all.map((dot) => dot.x))].sort((a, b) => a - b).map((value) => ({value}));
        };
        convergence.update("none");
    }

    function drawLegend() {
        const entry = (sign, words, paint) => {
            const item = document.createElement("li"), mark = document.createElement("span");
            mark.textContent = sign;
            if (paint) mark.style.color = paint;
            item.append(mark, " " + words);
            return item;
        };
        const by = element("colour").value, seen = new Set(points.map((point) => point.axes.shading));
        element("legend").replaceChildren(
            ...groups(by).map((words, i) => entry("\u25ac", words, palette()[i % kLight.length])),
            ...Object.keys(kSigns).filter((shading) => seen.has(shading)).map((shading) => entry(kSigns[shading], shading)),
            entry("\u25cb", "hollow: drawn in an unusual way"), entry("- - -", "nothing is both faster and more accurate"));
    }

    // ---- One choice ----

    const rows = [...document.querySelectorAll("#points tbody tr")];

    function show(point) {
        if (!point || state.chosen === point) return;
        state.chosen = point;
        for (const row of rows) row.classList.toggle("chosen", Number(row.dataset.point) === point.number);
        element("detail").hidden = false;
        nameChosen();
        for (const image of ["picture", "difference"]) {
            element("detail-" + image).hidden = !point[image];
            if (point[image]) element("detail-" + image).src = point[image];
        }
        element("detail-factor").textContent = "\u00d7 " + point.difference_factor;
        drawChart();
    }

    function nameChosen() {
        const point = state.chosen;
        if (point) element("detail-name").textContent = described(point) + (point.picture ? "" : "; its picture is missing");
    }

    function wipe() {
        element("truth").style.clipPath = `inset(0 0 0 ${element("wipe").value}%)`;
    }

    element("chart").addEventListener("keydown", (event) => {
        const key = {ArrowLeft: [milliseconds, -1], ArrowRight: [milliseconds, 1], ArrowDown: [error, -1], ArrowUp: [error, 1]}[event.key];
        if (!key) return;
        event.preventDefault();
        const [value, step] = key;
        const sorted = dotsOf().map((dot) => dot.point).sort((a, b) => value(a) - value(b));
        const at = sorted.indexOf(state.chosen);
        show(sorted[at < 0 ? 0 : Math.min(Math.max(at + step, 0), sorted.length - 1)]);
    });

    // ---- The target ----

    function target(isMoved) {
        const errors = dotsOf().map((dot) => dot.y);
        if (errors.length === 0) return;
        const [low, high] = [Math.log10(Math.min(...errors)), Math.log10(Math.max(...errors))];
        state.target = 10 ** (low + (high - low) * element("target").value / 1000);
        element("target-value").textContent = numeral(state.target);
        const best = visible().filter((point) => error(point) <= state.target * (1 + 1e-9))
            .sort((a, b) => milliseconds(a) - milliseconds(b))[0];
        element("target-choice").textContent = best ? "The fastest choice: " + described(best) + "." : "No choice is this accurate.";
        if (isMoved && best && best !== state.chosen) show(best);
        else drawChart();
    }

    // ---- Filters and the table ----

    function filter() {
        const shown = new Set(visible().map((point) => point.number));
        for (const row of rows) row.hidden = !shown.has(Number(row.dataset.point));
        draw();
    }

    for (const one of study.axes) {
        const set = document.createElement("fieldset"), legend = document.createElement("legend");
        legend.textContent = one.words;
        set.append(legend);
        state.hidden.set(one.name, new Set());
        for (const value of new Set(points.map((point) => point.values[one.name]))) {
            const label = document.createElement("label"), box = document.createElement("input");
            box.type = "checkbox";
            box.checked = true;
            box.addEventListener("change", () => {
                state.hidden.get(one.name)[box.checked ? "delete" : "add"](value);
                filter();
            });
            label.append(box, " " + value);
            set.append(label);
        }
        document.querySelector("#filters .filters").append(set);
    }

    for (const row of rows) {
        row.tabIndex = 0;
        for (const event of ["click", "focus"]) row.addEventListener(event, () => show(study.points[Number(row.dataset.point)]));
    }
    const table = element("points");
    [...table.tHead.rows[0].cells].forEach((head, column) => {
        const button = document.createElement("button");
        button.type = "button";
        button.className = "place";
        button.textContent = head.textContent;
        button.title = "sort by this column";
        head.replaceChildren(button);
        let sign = -1;
        button.addEventListener("click", () => {
            sign = -sign;
            for (const cell of table.tHead.rows[0].cells) cell.removeAttribute("aria-sort");
            head.setAttribute("aria-sort", sign > 0 ? "ascending" : "descending");
            const value = (row) => {
                const text = row.cells[column].textContent, number = Number.parseFloat(text);
                return Number.isNaN(number) || column === 0 ? text : number;
            };
            table.tBodies[0].append(...rows.slice().sort((a, b) => {
                const [x, y] = [value(a), value(b)];
                return sign * (typeof x === "number" && typeof y === "number" ? x - y
                    : String(x).localeCompare(String(y), "en", {numeric: true}));
            }));
        });
    });

    // ---- The controls above the plots ----

    const fill = (id, options) => element(id).append(...options.map(([value, words]) => new Option(words, value)));
    fill("measure", study.measures.map((one) => [one.name, one.words]));
    fill("colour", [...(severalMachines ? [["series", "machine"]] : []), ...study.axes.map((one) => [one.name, one.words])]);
    fill("renderer", [...new Set(points.filter((point) => point.axes.slices !== null).map((point) => point.values.renderer))]
        .map((words) => [words, words]));
    const shaders = points.find((point) => point.axes.renderer === "shaders");
    if (shaders && shaders.axes.slices !== null) element("renderer").value = shaders.values.renderer;

    function draw() {
        nameChosen();
        drawLegend();
        target(false);
        drawChart();
        drawConvergence();
    }

    for (const id of ["measure", "region", "colour", "renderer", "convergence-region"]) element(id).addEventListener("change", draw);
    element("target").addEventListener("input", () => target(true));
    element("wipe").addEventListener("input", wipe);
    dark.addEventListener("change", draw);
    element("truth").src = study.truth;
    wipe();
    draw();
})();
