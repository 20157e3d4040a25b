import { printable } from '../core/diagnostics.ts';
import { selectActor } from '../document/reconcile.ts';
import { selectedActor } from '../document/selected-actor.ts';
import { isUntouched } from '../document/untouched.ts';
import { pictureExtensions } from '../formats/extensions.ts';
import { extensionOf } from '../formats/file-entry.ts';
import { poseFormats } from '../formats/pose-formats.ts';
import { boneAt } from '../view/pick.ts';
import type { DropTarget } from './drop-zone.ts';

/** In CSS pixels. */
const tolerance = 8;

/** Extensions of what goes to a character: images, poses and motions. */
const givenExtensions = [
  ...pictureExtensions,
  ...poseFormats.map(({ extension }) => extension),
  '.anim',
];

/** A part of the view on which files can be dropped. */
interface Half {
  readonly label: string;
  readonly add: boolean;
}

/**
 * What the view shows while files hover over the window: what a drop on its left and on its right
 * half does, with the half under the pointer lit.
 */
export class DropHalves {
  private readonly target: DropTarget;
  private readonly view: HTMLElement;
  private readonly zone = document.body.appendChild(document.createElement('div'));
  private halves: readonly Half[] = [];
  private isForCharacter = false;

  constructor(target: DropTarget, view: HTMLElement) {
    this.target = target;
    this.view = view;
    this.zone.className = 'drop-zone';
    this.zone.popover = 'manual'; // over an open dialog, too
  }

  /**
   * Shows the halves, and lights the one at a place of the window.
   *
   * @param types of the files, as far as the browser tells them
   */
  follow(types: readonly string[], x: number): void {
    if (!this.isShown) this.show(types);
    const lit = this.halfAt(x);
    for (const [index, each] of Array.from(this.zone.children).entries()) {
      each.classList.toggle('lit', this.halves[index] === lit);
    }
  }

  hide(): void {
    if (this.isShown) this.zone.hidePopover();
  }

  /** Whether a drop at a place of the window adds the files. */
  addsAt(x: number): boolean {
    return this.isShown && this.halfAt(x)?.add === true;
  }

  /** Selects the character under a drop of what goes to one; elsewhere the selection stays. */
  selectUnder({ clientX, clientY, dataTransfer }: DragEvent): void {
    const names = Array.from(dataTransfer?.files ?? [], ({ name }) => extensionOf(name));
    const isForCharacter =
      this.isForCharacter ||
      (names.length > 0 && names.every((name) => givenExtensions.includes(name)));
    if (!this.isShown || !isForCharacter) return;
    const { left, top, width, height } = this.view.getBoundingClientRect();
    const [x, y] = [((clientX - left) / width) * 2 - 1, 1 - ((clientY - top) / height) * 2];
    if (Math.abs(x) > 1 || Math.abs(y) > 1) return;
    const hit = boneAt(this.target, { x, y, tolerance, viewHeight: height });
    const { session, store } = this.target;
    if (hit) selectActor(session, store.scene.value, hit.actorId);
  }

  private get isShown(): boolean {
    return this.zone.matches(':popover-open');
  }

  private halfAt(x: number): Half | undefined {
    const { left, width } = this.view.getBoundingClientRect();
    return x < left + width / 2 ? this.halves[0] : this.halves.at(-1);
  }

  private show(types: readonly string[]): void {
    this.isForCharacter = areForCharacter(types);
    this.halves = halvesFor(this.target, this.isForCharacter);
    const { left, top, width, height } = this.view.getBoundingClientRect();
    for (const [side, length] of Object.entries({ left, top, width, height })) {
      this.zone.style.setProperty(side, `${length}px`);
    }
    this.zone.replaceChildren(...this.halves.map(halfElement));
    this.zone.showPopover();
  }
}

/**
 * A drop replaces a scene that nobody touched; poses and pictures go to a character. Otherwise there
 * is a choice.
 */
function halvesFor({ store, session }: DropTarget, isForCharacter: boolean): readonly Half[] {
  const selected = selectedActor(store, session);
  if (selected && isForCharacter) return [{ label: 'Drop on a character', add: false }];
  if (!selected || isUntouched(store)) return [{ label: 'Drop to open', add: false }];
  return [
    { label: `Replace ${printable(selected.name, 60)}`, add: false },
    { label: 'Add', add: true },
  ];
}

/** Whether files are poses or pictures by their types, which some browsers tell with the drop only. */
function areForCharacter(types: readonly string[]): boolean {
  return types.length > 0 && types.every((type) => /^(image\/|application\/json$)/.test(type));
}

function halfElement({ label }: Half): HTMLElement {
  const half = document.createElement('div');
  half.textContent = label;
  return half;
}
