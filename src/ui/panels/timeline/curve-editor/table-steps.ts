/** A cell of a table. */
export interface CellPlace {
  readonly row: number;
  readonly column: number;
}

const pageStep = 10;

/** Where a key leads from a cell; null if it is not one that moves, or leads nowhere. */
export function stepOfKey(
  key: string,
  { row, column }: CellPlace,
  { rows, columns }: { readonly rows: number; readonly columns: number },
): CellPlace | null {
  const steps: Readonly<Record<string, CellPlace>> = {
    ArrowUp: { row: row - 1, column },
    ArrowDown: { row: row + 1, column },
    ArrowLeft: { row, column: column - 1 },
    ArrowRight: { row, column: column + 1 },
    PageUp: { row: row - pageStep, column },
    PageDown: { row: row + pageStep, column },
    Home: { row: 0, column },
    End: { row: rows - 1, column },
  };
  const to = steps[key];
  if (!to || rows === 0) return null;
  return {
    row: Math.min(Math.max(to.row, 0), rows - 1),
    column: Math.min(Math.max(to.column, 0), columns - 1),
  };
}
