// Inspects the page that is open: returns its identifiers, its links, and what a reader could not read.
(async () => {
  await document.fonts.ready;
  const findings = [];
  const shown = (element) => element.getClientRects().length > 0;
  const quoted = (text) => `"${text.trim().replace(/\s+/g, " ").slice(0, 60)}"`;
  const width = document.documentElement.clientWidth;

  for (const image of document.images) {
    if (!image.complete || image.naturalWidth === 0) {
      findings.push(`missing picture ${image.getAttribute("src")}`);
    }
  }

  for (const formula of document.querySelectorAll("math")) {
    const name = `formula ${quoted(formula.textContent)}`;
    if (formula.querySelector("merror")) findings.push(`${name} is an error`);
    if (!shown(formula)) continue;
    // A formula on a line of its own is as wide as the line: its parts are measured.
    const boxes = [...formula.children].map((part) => part.getBoundingClientRect());
    const left = Math.min(...boxes.map((box) => box.left));
    const right = Math.max(...boxes.map((box) => box.right));
    const height = Math.max(0, ...boxes.map((box) => box.height));
    if (!(height > 0 && right > left)) findings.push(`${name} has no size`);
    const room = formula.closest("main")?.clientWidth ?? width;
    if (right - left > room) {
      findings.push(`${name} is ${Math.ceil(right - left)} px wide, the page has ${room}`);
    }
  }

  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const code = "pre, code, kbd, script, style, template, textarea, noscript";
  while (texts.nextNode()) {
    const text = texts.currentNode;
    if (/\$|\\[A-Za-z]/.test(text.data) && !text.parentElement.closest(code)) {
      findings.push(`raw formula in ${quoted(text.data)}`);
    }
  }

  if (document.documentElement.scrollWidth > width) {
    findings.push(`the page is ${document.documentElement.scrollWidth} px wide, the window ${width}`);
  }
  const scrolls = (element) => {
    for (let at = element; at; at = at.parentElement) {
      if (/auto|scroll/.test(getComputedStyle(at).overflowX) && at !== document.body) return true;
    }
    return false;
  };
  const wide = [...document.querySelectorAll("main *, body > :not(script) *")].filter((element) => {
    const box = element.getBoundingClientRect();
    return shown(element) && box.width > 0 && box.right > width + 1 && !scrolls(element);
  });
  // Only the innermost elements: the others are wide because of them.
  const innermost = wide.filter((element) => !wide.some((other) => other !== element && element.contains(other)));
  for (const element of new Set(innermost.slice(0, 5))) {
    findings.push(`<${element.localName}> ${quoted(element.textContent)} leaves the page at the right`);
  }

  const links = [...document.querySelectorAll("a[href]")].map((link) => {
    const to = new URL(link.href);
    const anchor = decodeURIComponent(to.hash.slice(1));
    to.hash = "";
    return { text: link.getAttribute("href"), to: to.href, anchor };
  });
  const ids = [...document.querySelectorAll("[id], a[name]")].map((element) => element.id || element.name);
  const height = document.documentElement.scrollHeight;
  return JSON.stringify({ href: location.href, ids, links, findings, height });
})();
