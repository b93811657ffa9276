// Proves bounds in a worker. A new question stops the proof of the last one.
class Prover {
  constructor(module) {
    this.module = module;
    const text = ["glue", "worker"].map((id) => document.getElementById(id).textContent).join("\n");
    this.address = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
  }

  start() {
    this.worker = new Worker(this.address);
    this.worker.postMessage({ module: this.module });
  }

  // Calls `then` with the answer, unless the question is withdrawn before.
  ask(question, then) {
    this.withdraw();
    if (!this.worker) this.start();
    this.busy = true;
    const done = (answer) => {
      this.busy = false;
      then(answer);
    };
    this.worker.onmessage = ({ data }) => done(JSON.parse(data));
    this.worker.onerror = (event) => {
      event.preventDefault();
      this.worker.terminate();
      this.worker = null;
      done({ Err: { message: `the proof failed: ${event.message || "no worker"}` } });
    };
    this.worker.postMessage({ question });
  }

  withdraw() {
    if (!this.busy) return;
    this.busy = false;
    this.worker.terminate();
    this.worker = null;
  }
}
