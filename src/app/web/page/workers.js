// Web Workers that share a queue of tasks.

export class Workers {
    // startWorker(): a Worker; wasm: the compiled module.
    constructor(count, startWorker, wasm) {
        Object.assign(this, {startWorker, wasm});
        this.queue = [];
        this.waiting = new Map();  // by id
        this.all = Array.from({length: count}, () => this.started());
        this.idle = [...this.all];
        this.next = 0;
    }

    // A promise of the task's result. It never settles if forget() drops the task. `soon`: before the tasks that wait.
    do(task, {soon = false, keep = false} = {}) {
        return new Promise((resolve, reject) => {
            if (this.failure) return reject(this.failure);
            this.queue[soon ? "unshift" : "push"]({task, keep, resolve, reject});
            this.start();
        });
    }

    // Gives all workers these files, [name, bytes] each, for the scenes of later tasks.
    keep(files) {
        for (const worker of this.all) worker.postMessage({files});
    }

    // Drops the tasks that have not begun, except those to keep. Those that have end, but nobody waits for them.
    forget() {
        this.queue = this.queue.filter(({keep}) => keep);
        for (const [id, {keep}] of this.waiting) if (!keep) this.waiting.delete(id);
    }

    started() {
        const worker = this.startWorker();
        worker.postMessage({wasm: this.wasm});
        worker.addEventListener("message", ({data: {id, result, error}}) => {
            const entry = this.waiting.get(id);
            this.waiting.delete(id);
            this.idle.push(worker);
            if (error !== undefined) entry?.reject(new Error(error));
            else entry?.resolve(result);
            this.start();
        });
        worker.addEventListener("error", ({message}) => this.fail(new Error(`a worker of the page failed: ${message ?? "the browser did not load it"}`)));
        return worker;
    }

    // After this, no task ends.
    fail(error) {
        this.failure ??= error;
        for (const {reject} of [...this.queue, ...this.waiting.values()]) reject(this.failure);
        this.queue = [];
        this.waiting.clear();
    }

    start() {
        while (this.queue.length > 0 && this.idle.length > 0) {
            const {task, ...entry} = this.queue.shift(), id = this.next++;
            this.waiting.set(id, entry);
            this.idle.pop().postMessage({id, ...task});
        }
    }
}
