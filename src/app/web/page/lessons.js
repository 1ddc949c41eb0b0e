// The panel of a lesson: a question, a prediction, a task, and the check of the answer, which is the scene in the editor. Its words
// come from the module.

const at = (id) => document.getElementById(id);

// Paragraphs, with code in backquotes.
function prose(text) {
    return text.split(/\n\n+/).map((part) => {
        const paragraph = document.createElement("p");
        paragraph.append(...part.split("`").map((piece, i) => {
            if (i % 2 === 0) return piece;
            const code = document.createElement("code");
            code.textContent = piece;
            return code;
        }));
        return paragraph;
    });
}
function element(kind, text, id = "") {
    const made = document.createElement(kind);
    made.textContent = text;
    if (id) made.id = id;
    return made;
}
function button(text, id, click) {
    const made = element("button", text, id);
    made.type = "button";
    made.addEventListener("click", click);
    return made;
}

export class Lessons {
    // open(text): shows this text as the lesson's scene; text(): the answer now; check(lesson, text): a promise of its grade;
    // next(lesson): opens another lesson.
    constructor({words, lessons}, {open, text, check, next}) {
        Object.assign(this, {words, lessons, open, text, check, next});
    }

    find(name) { return this.lessons.find((lesson) => lesson.name === name); }

    hide() {
        at("lesson").hidden = true;
        this.lesson = null;
    }

    show(lesson) {
        this.lesson = lesson;
        this.checked = null;
        const {words} = this, seen = element("div", "", "seen"), result = element("p", "", "result");
        result.setAttribute("role", "status");
        const place = this.lessons.indexOf(lesson), following = place < 0 ? undefined : this.lessons[place + 1];
        const choices = document.createElement("p");
        choices.className = "choices";
        choices.append(...lesson.choices.map((choice, i) =>
            button(`${String.fromCharCode(65 + i)}. ${choice.replaceAll("`", "")}`, "", () => this.predict(i, choices, seen))));
        at("lesson").replaceChildren(
            element("h2", lesson.title), ...prose(lesson.about), ...prose(lesson.question),
            element("h3", words.prediction), ...prose(lesson.prediction), choices, seen,
            element("h3", words.task), ...prose(lesson.task),
            button(words.check, "check", () => this.grade()), result);
        if (following) at("lesson").append(button(words.next, "next-lesson", () => this.next(following)));
        at("lesson").hidden = false;
    }

    // Only the first prediction counts.
    predict(choice, choices, seen) {
        const {lesson, words} = this;
        for (const [i, made] of [...choices.children].entries()) {
            made.disabled = true;
            if (i === choice) made.classList.add("chosen");
        }
        seen.replaceChildren(
            ...prose(`${lesson.verdicts[choice]} ${lesson.seen}`),
            button(words.showChange, "show-change", () => this.open(lesson.changed)),
            button(words.showStart, "show-start", () => this.open(lesson.scene)));
    }

    async grade() {
        const {lesson, words} = this, text = this.text(), result = at("result");
        result.className = "";
        result.textContent = words.checking;
        try {
            const {right, reason} = await this.check(lesson, text);
            if (this.lesson !== lesson) return;
            this.checked = text;
            result.className = right ? "right" : "wrong";
            result.textContent = right ? `${words.right} ${lesson.because}` : `${words.notYet} ${reason.replaceAll("`", "")}`;
        } catch (error) {
            result.textContent = error.message;
        }
    }

    // After each change of the text.
    changed(text) {
        if (!this.lesson || this.checked === null || this.checked === text) return;
        this.checked = null;
        at("result").className = "";
        at("result").textContent = this.words.outdated;
    }
}
