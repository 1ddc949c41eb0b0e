// Dark or light: as the system, until the button chooses.

const KEY = "twinlight-theme";
const OTHER = {dark: "light", light: "dark"};

// Where the browser keeps nothing for a page from the disk, the choice lasts as long as the page.
function stored(theme) {
    try {
        if (theme) localStorage.setItem(KEY, theme);
        return localStorage.getItem(KEY);
    } catch {
        return null;
    }
}

export function startTheme(button) {
    const system = matchMedia("(prefers-color-scheme: dark)"), {dataset} = document.documentElement;
    const chosen = () => dataset.theme ?? (system.matches ? "dark" : "light");
    const show = () => {
        button.textContent = chosen() === "dark" ? "Light" : "Dark";
        button.ariaLabel = button.textContent + ": change the colours of the page";
    };
    if (stored() in OTHER) dataset.theme = stored();
    button.addEventListener("click", () => {
        dataset.theme = OTHER[chosen()];
        stored(dataset.theme);
        show();
    });
    system.addEventListener("change", show);
    show();
}
