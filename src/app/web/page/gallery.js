// The dialog of all scenes, as pictures by the lecture's headings. scenes.json is loaded when it first opens.
import {file} from "./own_files.js";

function element(kind, text = "") {
    const made = document.createElement(kind);
    made.textContent = text;
    return made;
}

// builtIn: the scenes, with what they show; open(name).
export function startGallery(button, dialog, builtIn, open) {
    const shows = new Map(builtIn.map(({name, shows}) => [name, shows]));
    function card(name, picture) {
        const made = element("button"), image = element("img");
        made.type = "button";
        made.title = shows.get(name);
        [image.src, image.alt, image.width, image.height] = [picture, "", 160, 120];
        made.append(image, element("span", name));
        made.addEventListener("click", () => {
            dialog.close();
            open(name);
        });
        return made;
    }
    const list = dialog.querySelector("div");
    button.addEventListener("click", async () => {
        dialog.showModal();
        if (list.childElementCount > 0) return;
        const {groups, pictures} = await (await file("scenes.json")).json();
        list.replaceChildren(...groups.map(({heading, scenes}) => {
            const section = element("section"), cards = element("div");
            cards.append(...scenes.map((name) => card(name, pictures[name])));
            section.append(element("h3", heading), cards);
            return section;
        }));
    });
    // A click beside the dialog closes it.
    dialog.addEventListener("click", ({target}) => target === dialog && dialog.close());
}
