// Proves bounds beside the page, which stays responsive meanwhile.
onmessage = ({ data: { module, question } }) => {
  if (module) wasm_bindgen.initSync({ module });
  if (question) postMessage(wasm_bindgen.prove(...question));
};
