// The editor of the scene's text: CodeMirror 5, a script before this one, with our messages at their lines.

// Highlights by the form of a word, so there is no list of commands here.
const WORDS = [
    [/^\/\/.*/, "comment"],
    [/^#.*/, "meta"],
    [/^(?:gl|glu|glut)[A-Z]\w*/, "builtin"],
    [/^(?:GL|GLU|GLUT)_\w+/, "atom"],
    [/^(?:0x[\da-f]+|(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)[uflh]*/i, "number"],
    [/^"(?:[^"\\]|\\.)*"?/, "string"],
    [/^(?:break|case|char|const|continue|default|do|double|else|float|for|if|int|return|sizeof|static|struct|switch|unsigned|void|while)\b/, "keyword"],
    [/^\w+/, null],
];

CodeMirror.defineMode("scene", () => ({
    startState: () => ({inComment: false}),
    token(stream, state) {
        if (!state.inComment && stream.match("/*")) state.inComment = true;
        if (state.inComment) {
            state.inComment = !stream.match(/^.*?\*\//);
            if (state.inComment) stream.skipToEnd();
            return "comment";
        }
        for (const [form, style] of WORDS) if (stream.match(form)) return style;
        stream.next();
        return null;
    },
}));

export class Editor {
    // typed(): after each change that does not come from set().
    constructor(place, typed) {
        this.editor = CodeMirror(place, {
            mode: "scene", lineNumbers: true, gutters: ["marks", "CodeMirror-linenumbers"], indentUnit: 4, inputStyle: "contenteditable",
            screenReaderLabel: document.getElementById("text-label").textContent,
            extraKeys: {Tab: false, "Shift-Tab": false},  // they move the focus, so that the keyboard can leave the editor
            dragDrop: false,  // a file that is dropped anywhere on the page is opened
        });
        this.editor.on("changes", (_, changes) => {
            if (changes.some(({origin}) => origin !== "page" && origin !== "+page")) typed();
        });
    }

    get text() { return this.editor.getValue(); }

    // Replaces what differs, as one step of undo; `joins`: as a part of the step before, if that was less than a second or so ago.
    set(text, {joins = false} = {}) {
        const before = this.text, shorter = Math.min(before.length, text.length);
        if (before === text) return;
        let front = 0, back = 0;
        while (front < shorter && before[front] === text[front]) ++front;
        while (back < shorter - front && before[before.length - 1 - back] === text[text.length - 1 - back]) ++back;
        const at = (index) => this.editor.posFromIndex(index), {top} = this.editor.getScrollInfo();
        this.editor.replaceRange(text.slice(front, text.length - back), at(front), at(before.length - back), joins ? "+page" : "page");
        this.editor.scrollTo(null, top);
    }

    // Shows another scene.
    open(text) {
        this.set(text);
        this.editor.setCursor(0, 0, {scroll: false});
        this.editor.scrollTo(0, 0);
    }

    // After it was hidden.
    refresh() { this.editor.refresh(); }

    select(line, column) {
        this.editor.focus();
        this.editor.setSelection({line: line - 1, ch: column - 1}, {line: line - 1, ch: Infinity});
        this.editor.scrollIntoView(null, 80);
    }

    // ---- Messages at their lines ----

    clear() {
        this.editor.clearGutter("marks");
        for (const mark of this.editor.getAllMarks()) mark.clear();
    }

    mark(kind, {line, column, text}) {
        if (line > this.editor.lineCount()) return;
        const info = this.editor.lineInfo(line - 1), before = info.gutterMarkers?.marks, sign = before ?? document.createElement("div");
        // An error is more important than a warning.
        if (!before || kind === "error") sign.className = "mark " + kind;
        sign.title += (sign.title && "\n") + `${kind}: ${text}`;
        this.editor.setGutterMarker(line - 1, "marks", sign);
        const start = Math.max(column - 1, info.text.search(/\S|$/));
        this.editor.markText({line: line - 1, ch: start}, {line: line - 1, ch: info.text.trimEnd().length},
            {className: "marked " + kind, attributes: {title: `${kind}: ${text}`}});
    }
}
