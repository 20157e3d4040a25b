import { useState } from 'preact/hooks';

interface TypedFieldProperties {
  readonly label: string;
  readonly value: string;
  /** Shown while the value is empty, as of keys that differ. */
  readonly placeholder?: string;
  readonly disabled?: boolean;
  /** Returns whether the text was understood. */
  readonly onType: (text: string) => boolean;
}

/** A field whose text is taken by Enter or by leaving it; Escape restores what it was. */
export function TypedField({ label, value, placeholder, disabled, onType }: TypedFieldProperties) {
  const [typed, setTyped] = useState<string | null>(null);
  const [isWrong, setWrong] = useState(false);
  const take = (): void => {
    if (typed === null || typed === value) {
      setTyped(null);
      return;
    }
    const isTaken = onType(typed);
    setWrong(!isTaken);
    if (isTaken) setTyped(null);
  };
  return (
    <input
      type="text"
      spellcheck={false}
      autocomplete="off"
      aria-label={label}
      aria-invalid={isWrong}
      placeholder={placeholder}
      disabled={disabled}
      value={typed ?? value}
      onInput={({ currentTarget }) => {
        setTyped(currentTarget.value);
        setWrong(false);
      }}
      onFocus={({ currentTarget }) => currentTarget.select()}
      onBlur={take}
      onKeyDown={(event) => {
        if (event.key === 'Enter') take();
        if (event.key !== 'Escape' || typed === null) return;
        event.stopPropagation();
        setTyped(null);
        setWrong(false);
      }}
    />
  );
}
