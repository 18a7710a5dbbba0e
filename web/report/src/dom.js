/** An element with attributes, listeners ("onclick") and children, of which null ones are left out. */
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (name in element) element[name] = value;
    else element.setAttribute(name, value);
  }
  element.append(...children.flat().filter((child) => child !== null));
  return element;
}

/** Calls back, with true or false, when an element comes near what is seen of the page, and when it leaves. */
export function whenNear(element, margin, call) {
  new IntersectionObserver((entries) => call(entries.at(-1).isIntersecting), { rootMargin: `${margin}px` })
    .observe(element);
}

/** With three digits, and no more than a reader can use. */
export function readable(value) {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size === 0) return '0';
  if (size >= 1e7 || size < 1e-4) return value.toExponential(2);
  if (size >= 100) return value.toFixed(0);
  return value.toFixed(size >= 10 ? 1 : size >= 1 ? 2 : 3);
}
