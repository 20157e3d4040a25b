import type { ComponentChildren } from 'preact';
import { useRef } from 'preact/hooks';

interface MenuProperties {
  readonly id: string;
  readonly label: string;
  /** Buttons with the role of menu items, and rules between them. */
  readonly children: ComponentChildren;
}

/** A button with a list that opens below or above it, over everything, and closes by any press or Escape. */
export function Menu({ id, label, children }: MenuProperties) {
  const button = useRef<HTMLButtonElement>(null);
  const list = useRef<HTMLDivElement>(null);
  const items = (): HTMLElement[] =>
    Array.from(list.current?.querySelectorAll<HTMLElement>('button:not(:disabled)') ?? []);
  const onToggle = (): void => {
    const isOpen = list.current?.matches(':popover-open') === true;
    button.current?.setAttribute('aria-expanded', String(isOpen));
    if (!isOpen || !list.current || !button.current) return;
    const { left, top, bottom } = button.current.getBoundingClientRect();
    const { offsetWidth, offsetHeight } = list.current;
    // At the foot of the page it opens above its button.
    const isBelow = bottom + 4 + offsetHeight <= window.innerHeight;
    Object.assign(list.current.style, {
      left: `${Math.max(0, Math.min(left, window.innerWidth - offsetWidth))}px`,
      top: `${isBelow ? bottom + 4 : Math.max(0, top - 4 - offsetHeight)}px`,
    });
    items()[0]?.focus();
  };
  const onKeyDown = (event: KeyboardEvent): void => {
    const all = items();
    const at = all.indexOf(document.activeElement as HTMLElement);
    const targets: Record<string, number> = {
      ArrowDown: at + 1,
      ArrowUp: at - 1,
      Home: 0,
      End: -1,
    };
    const target = targets[event.key];
    if (target === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    all.at(target % all.length)?.focus();
  };
  return (
    <>
      <button
        ref={button}
        type="button"
        aria-haspopup="menu"
        aria-expanded="false"
        popovertarget={id}
        class="menu-button"
      >
        {label}
      </button>
      <div
        ref={list}
        id={id}
        popover="auto"
        role="menu"
        aria-label={label}
        class="menu"
        onToggle={onToggle}
        onKeyDown={onKeyDown}
        onClick={() => list.current?.hidePopover()}
      >
        {children}
      </div>
    </>
  );
}
