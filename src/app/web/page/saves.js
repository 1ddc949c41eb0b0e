// Files of the scene and its pictures.

const at = (id) => document.getElementById(id);

// What the module can write, by its name of the form.
const FORMS = {
    c: {title: "C program", ending: ".c", type: "text/plain"},
    glsl: {title: "shaders in GLSL", ending: ".glsl", type: "text/plain"},
    html: {title: "page with WebGL 2", ending: ".html", type: "text/html"},
};

// Offers the scene, the forms in `forms`, and the pictures that are shown.
export function offer(forms) {
    const pictures = [...document.querySelectorAll("figure:not([hidden])")].map((figure) =>
        new Option("picture: " + figure.querySelector("figcaption span").textContent, "#" + figure.querySelector("canvas").id));
    const chosen = at("form").value;
    at("form").replaceChildren(new Option("scene (.gl)", "gl"), ...forms.map((form) => new Option(`${FORMS[form].title} (${FORMS[form].ending})`, form)), ...pictures);
    if ([...at("form").options].some(({value}) => value === chosen)) at("form").value = chosen;
}

export async function save(form, name, twinlight, text) {
    if (form === "gl") return download(name + ".gl", new Blob([text], {type: "text/plain"}));
    if (form.startsWith("#")) {
        const canvas = at(form.slice(1));
        return download(`${name}-${canvas.id}.png`, await new Promise((resolve) => canvas.toBlob(resolve, "image/png")));
    }
    const {ending, type} = FORMS[form];
    download(name + ending, new Blob([twinlight.exported(form, at("shading").value)], {type}));
}

function download(name, blob) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
