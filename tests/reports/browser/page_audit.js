// What is wrong with the page that is open, as a list of sentences. Shapes are those that the browser laid out.
(() => {
  const faults = [];
  const width = document.documentElement.clientWidth;
  const name = (element) => {
    const text = element.textContent.trim().replace(/\s+/g, ' ').slice(0, 60);
    return `<${element.tagName.toLowerCase()} class="${element.getAttribute('class') || ''}"> "${text}"`;
  };
  const beyond = (inner, outer, slack) =>
    inner.left < outer.left - slack || inner.right > outer.right + slack ||
    inner.top < outer.top - slack || inner.bottom > outer.bottom + slack;

  if (document.documentElement.scrollWidth > width)
    faults.push(`the page is ${document.documentElement.scrollWidth} px wide in a window of ${width} px`);

  // Every text lies within the card (figure, card, table frame) that holds it. A table may scroll in its frame, and
  // then has to show that it does.
  const range = document.createRange();
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const parent = node.parentElement;
    if (!node.data.trim() || parent.closest('script,style,.scroll,[hidden]')) continue;
    range.selectNodeContents(node);
    const holder = parent.closest('figure,.card') || parent.closest('main');
    const frame = holder.getBoundingClientRect();
    for (const box of range.getClientRects())
      if (box.width > 0 && beyond(box, frame, 1)) {
        faults.push(`text beyond its ${holder.tagName.toLowerCase()}: ${name(parent)}`);
        break;
      }
  }

  // Pictures: as wide as their card lets them, something drawn in each, every text inside the picture, no two tick
  // labels on top of each other, nothing in the lettering's colour that cannot be read.
  let pictures = 0;
  for (const figure of document.querySelectorAll('figure')) {
    const svg = figure.querySelector('svg');
    if (!svg) {
      if (!figure.querySelector('canvas')) faults.push(`no picture in ${name(figure)}`);
      continue;
    }
    ++pictures;
    const box = svg.getBoundingClientRect();
    const title = figure.querySelector('figcaption').textContent;
    if (box.width < 200 || box.height < 100) faults.push(`${title}: ${box.width} x ${box.height} px`);
    const drawn = [...svg.querySelectorAll('svg path, svg circle, g[shape-rendering] path')].some((path) => {
      const d = path.getAttribute('d');
      return path.tagName === 'circle' || (d && d.length > 8 && !/NaN|inf/i.test(d));
    });
    if (!drawn) faults.push(`${title}: nothing is drawn`);
    const texts = [...svg.querySelectorAll('text')];
    const boxes = texts.map((text) => text.getBoundingClientRect());
    boxes.forEach((text, i) => {
      if (beyond(text, box, 0.5)) faults.push(`${title}: "${texts[i].textContent}" is cut off at the edge`);
      if (parseFloat(getComputedStyle(texts[i]).fontSize) * box.width / svg.viewBox.baseVal.width < 9)
        faults.push(`${title}: "${texts[i].textContent}" is smaller than 9 px`);
      for (let j = 0; j < i; ++j) {
        const other = boxes[j];
        const across = Math.min(text.right, other.right) - Math.max(text.left, other.left);
        const down = Math.min(text.bottom, other.bottom) - Math.max(text.top, other.top);
        if (across > 1 && down > 3) {
          faults.push(`${title}: "${texts[j].textContent}" and "${texts[i].textContent}" overlap`);
          break;
        }
      }
    });
  }

  // A table that is wider than its frame says so: its frame is marked (style.cpp draws a shadow at the cut edge).
  let scrolling = 0;
  for (const frame of document.querySelectorAll('.scroll')) {
    if (frame.scrollWidth <= frame.clientWidth + 1) continue;
    ++scrolling;
    if (getComputedStyle(frame).backgroundImage === 'none') faults.push(`cut without a hint: ${name(frame)}`);
  }

  // Lettering is readable on its ground: contrast of at least 4.5 (WCAG 2 AA).
  const light = (colour) => {
    const [r, g, b] = colour.match(/[\d.]+/g).slice(0, 3).map((c) => {
      const x = c / 255;
      return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const ground = (element) => {
    for (let e = element; e; e = e.parentElement) {
      const colour = getComputedStyle(e).backgroundColor;
      if (!/, 0\)$|transparent/.test(colour)) return colour;
    }
    return 'rgb(255, 255, 255)';
  };
  const faint = new Set();
  for (const element of document.querySelectorAll('p,h1,h2,h3,td,th,li,a,b,code,span,figcaption,svg text,summary')) {
    if (!element.textContent.trim()) continue;
    const style = getComputedStyle(element);
    const ink = light(element.tagName === 'text' ? style.fill : style.color), paper = light(ground(element));
    const contrast = (Math.max(ink, paper) + 0.05) / (Math.min(ink, paper) + 0.05);
    if (contrast < 4.5) faint.add(`contrast ${contrast.toFixed(1)}: ${element.tagName} class ${element.className.baseVal ?? element.className}`);
  }
  faults.push(...faint);

  const ids = [...document.querySelectorAll('nav a')].map((a) => a.getAttribute('href').slice(1));
  for (const id of ids) if (!document.getElementById(id)) faults.push(`the contents lead to #${id}, which is not there`);
  const headline = document.querySelector('h1').textContent.trim().split(/\s+/).length;
  if (headline > 20) faults.push(`the headline has ${headline} words`);
  return { faults: [...new Set(faults)], pictures, scrolling };
})()
