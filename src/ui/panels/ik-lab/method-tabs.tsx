import type { IkLab } from '../../ik-lab.ts';

/** The methods, of which one is shown step by step. Each has a color and a dash in the plot. */
export function MethodTabs({ lab }: { readonly lab: IkLab }) {
  const { methods, methodId } = lab;
  const onKeyDown = (event: KeyboardEvent): void => {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const now = methods.findIndex(({ id }) => id === methodId.value);
    const next = methods.at((now + by) % methods.length)!;
    lab.chooseMethod(next.id);
    const list = event.currentTarget as HTMLElement;
    list.querySelector<HTMLElement>(`[data-method="${next.id}"]`)?.focus();
  };
  return (
    <div class="methods" role="tablist" aria-label="Method" onKeyDown={onKeyDown}>
      {methods.map(({ id, label }) => {
        const isOpen = id === methodId.value;
        return (
          <button
            key={id}
            type="button"
            role="tab"
            data-method={id}
            aria-selected={isOpen}
            aria-controls="ik-lab-method"
            tabIndex={isOpen ? 0 : -1}
            title={label}
            onClick={() => lab.chooseMethod(id)}
          >
            <svg class={`sample method-${id}`} viewBox="0 0 22 8" aria-hidden="true">
              <path d="M1 4h20" />
            </svg>
            {id.toUpperCase()}
          </button>
        );
      })}
    </div>
  );
}
