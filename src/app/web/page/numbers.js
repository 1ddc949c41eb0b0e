// Three numbers of the scene's lighting to drag, which the module finds in its text.

const DRAG_STEPS = 200;  // the range of a number without a limit, from its value each way

// changed(number, value): after each move.
export class Numbers {
    constructor(place, changed) {
        Object.assign(this, {place, changed});
        this.names = "";
    }

    // numbers: what twinlight.numbers() answers. The ranges stay while the numbers are the same ones.
    show(numbers) {
        this.numbers = numbers;
        const names = numbers.map(({name}) => name).join("\n");
        const stay = names === this.names && numbers.every(({value}, i) => this.inputs[i].min <= value && value <= this.inputs[i].max);
        if (!stay) {
            this.names = names;
            this.place.replaceChildren(...numbers.map((number, i) => this.made(number, i)));
            this.inputs = [...this.place.querySelectorAll("input")];
        }
        numbers.forEach(({value}, i) => this.shown(i, value));
        this.place.hidden = numbers.length === 0;
    }

    made({name, value, smallest, largest, step}, index) {
        const label = document.createElement("label"), input = document.createElement("input"), output = document.createElement("output");
        Object.assign(input, {type: "range", min: smallest ?? value - DRAG_STEPS * step, max: largest ?? value + DRAG_STEPS * step, step, ariaLabel: name});
        input.addEventListener("input", () => {
            this.shown(index, input.valueAsNumber);
            this.changed(this.numbers[index], input.valueAsNumber);
        });
        const words = document.createElement("span");
        words.textContent = name;
        label.append(words, output, input);
        return label;
    }

    shown(index, value) {
        this.inputs[index].value = value;
        this.place.querySelectorAll("output")[index].textContent = Number(value.toPrecision(6));
    }
}
