// The pages of a folder in the states that people see: page/ (the page for browsers), export.html and report/index.html, in both themes
// and in two sizes.

// look(name): called at each.
export async function forEachView(browser, look) {
    for (const [width, height, dark] of [[1280, 800, true], [390, 844, false]]) {
        const where = `${dark ? "dark" : "light"}, ${width} pixels`;
        const open = async (place, ready) => {
            await browser.visit("package.json");  // or only the fragment would change
            await browser.visit(place);
            await browser.until(ready, 60);
        };
        await browser.size(width, height, dark);
        await open("page/index.html#scene=terms", "document.body?.dataset.drawn");
        await browser.value(`document.getElementById("probe").requestSubmit(), document.getElementById("keys").open = true`);
        await look(`the page, ${where}`);
        await browser.value(`document.getElementById("all-scenes").click()`);
        await browser.until(`document.querySelector("#gallery img")?.complete`);
        await look(`the page's list of scenes, ${where}`);
        await open("page/index.html#lesson=shininess", `document.body?.dataset.drawn && !document.getElementById("lesson").hidden`);
        await look(`a lesson, ${where}`);
        await open("page/index.html#tutor=light", "document.body?.dataset.drawn");
        await look(`a tutor, ${where}`);
        await open("export.html", `document.readyState === "complete" && document.querySelector("#lights button")`);
        await browser.drag("picture");
        await look(`an exported page, ${where}`);
        await open("report/index.html", `document.readyState === "complete" && document.querySelector("h1")`);
        await look(`a report, ${where}`);
    }
}
