// Colours that the colour-blind tell apart (Okabe and Ito 2008), and what the theme says of lines and text.

export const palette = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8c6d1f", "#7f7f7f"];
export const colour = (k: number): string => palette[k % palette.length] ?? "#0072b2";
/** The second time round lines are dashed. */
export const dash = (k: number): number[] => (Math.floor(k / palette.length) % 2 === 1 ? [6, 4] : []);

export const themed = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

const listeners = new Set<() => void>();
export const onTheme = (redraw: () => void): void => void listeners.add(redraw);
export const themeChanged = (): void => listeners.forEach((redraw) => redraw());
