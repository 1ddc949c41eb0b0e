// Keys and the mouse over the pictures, as in the window. The module has the list of keys and carries them out.

const SPECIAL = 0x100;  // session::kSpecialKey, then GLUT's numbers
const GLUT = {F1: 1, ArrowLeft: 100, ArrowUp: 101, ArrowRight: 102, ArrowDown: 103};
// The codes of the arrow keys, and where they point.
export const ARROWS = new Map(Object.entries({ArrowLeft: [-1, 0], ArrowUp: [0, -1], ArrowRight: [1, 0], ArrowDown: [0, 1]}).map(([key, to]) => [SPECIAL + GLUT[key], to]));
const CLICK_PIXELS = 4;  // a drag that is shorter is a click
const WHEEL_STEP = {0: 100, 1: 3, 2: 1};  // by WheelEvent.deltaMode: pixels, lines, pages

function codeOf({key, ctrlKey, altKey, metaKey}) {
    if (ctrlKey || altKey || metaKey) return null;
    if (key in GLUT) return SPECIAL + GLUT[key];
    return key.length === 1 ? key.codePointAt(0) : null;
}

// The pixel of the picture under the mouse.
function pixelAt(canvas, {clientX, clientY}) {
    const box = canvas.getBoundingClientRect();
    return [(clientX - box.left) * canvas.width / box.width, (clientY - box.top) * canvas.height / box.height].map(Math.floor);
}

// twinlight: the module's functions, or others for another picture. ready(): whether a scene is open, and nothing that was typed is unread; done(answer): after each key and move, with isMoving for the mouse; click(x, y).
export function control(canvas, twinlight, {ready, done, click}) {
    canvas.addEventListener("keydown", (event) => {
        const code = codeOf(event);
        if (code === null || !ready()) return;
        const answer = twinlight.press(code);
        if (!answer.known) return;
        event.preventDefault();
        done(answer);
    });

    let drag = null;
    canvas.addEventListener("pointerdown", (event) => {
        if ((event.button !== 0 && event.button !== 2) || !ready()) return;
        drag = {from: pixelAt(canvas, event), looks: event.button === 2, to: null, isWaiting: false};
        canvas.setPointerCapture(event.pointerId);
        twinlight.startDrag(event.shiftKey, drag.from);
    });
    canvas.addEventListener("pointermove", (event) => {
        if (!drag) return;
        const [x, y] = pixelAt(canvas, event), to = [x - drag.from[0], y - drag.from[1]];
        if (!drag.to && Math.max(...to.map(Math.abs)) < CLICK_PIXELS) return;
        drag.to = to;
        if (drag.isWaiting) return;
        drag.isWaiting = true;  // one picture for a frame of the screen
        const moved = drag;
        requestAnimationFrame(() => {
            moved.isWaiting = false;
            if (ready()) done({...twinlight.drag(moved.looks, ...moved.to), isMoving: true});
        });
    });
    canvas.addEventListener("pointerup", (event) => {
        if (drag && !drag.to && !drag.looks) click(...pixelAt(canvas, event));
        drag = null;
        twinlight.endDrag();
    });
    canvas.addEventListener("pointercancel", () => drag = null);
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());

    // The wheel scrolls the page until a picture is clicked.
    let turned = 0;
    canvas.addEventListener("wheel", (event) => {
        if (document.activeElement !== canvas || !ready()) return;
        event.preventDefault();
        turned -= event.deltaY / WHEEL_STEP[event.deltaMode];
        const steps = Math.trunc(turned);
        turned -= steps;
        if (steps !== 0) done({...twinlight.zoom(steps), isMoving: true});
    }, {passive: false});
}

export function showKeys(table, keys) {
    for (const {label, what} of keys.filter(({label}) => label)) {
        const row = table.insertRow();
        for (const text of [label, what]) row.insertCell().textContent = text;
    }
}
