import { useEffect, useRef, useState } from 'preact/hooks';
import type { Skeleton } from '../../core/skeleton.ts';
import { jointColorsOf } from '../../skinning/weights/joint-colors.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { selectedJoints } from '../../document/selected-joints.ts';
import { selectJoint, selectJoints, toggleJoint } from '../../document/select-joints.ts';
import { cssColor } from '../css-color.ts';
import type { Actions, Looking } from '../editor.ts';
import { hoveredOf } from '../hovered-limb.ts';
import { pressedAttribute } from '../keys.ts';
import { TypeAhead } from '../type-ahead.ts';
import { ancestorsOf, type TreeRow, visibleRows } from '../joint-rows.ts';

/** The joints as a tree that can be searched, folded and selected from, by pointer or keys. */
export function JointTree({ editor }: { readonly editor: Looking & Actions }) {
  const skeleton = selectedActor(editor.store, editor.session)?.character.skeleton;
  if (!skeleton || skeleton.jointCount === 0) return null;
  return <Tree key={skeleton.names.join()} editor={editor} skeleton={skeleton} />;
}

/** A longer tree begins with its upper levels alone. */
const longTree = 120;
const levelsAtFirst = 4;

function foldedAtFirst({ jointCount, depths }: Skeleton): ReadonlySet<number> {
  if (jointCount <= longTree) return new Set();
  const joints = Array.from({ length: jointCount }, (_, joint) => joint);
  return new Set(joints.filter((joint) => depths[joint]! >= levelsAtFirst - 1));
}

interface TreeProperties {
  readonly editor: Looking & Actions;
  readonly skeleton: Skeleton;
}

function Tree({ editor, skeleton }: TreeProperties) {
  const [search, setSearch] = useState('');
  const [folded, setFolded] = useState<ReadonlySet<number>>(() => foldedAtFirst(skeleton));
  const [current, setCurrent] = useState(0);
  const list = useRef<HTMLUListElement>(null);
  const typeAhead = useRef(new TypeAhead());
  const { session } = editor;
  const { selectedJoint, showWeights, hoveredLimb, selectedActorId } = session;
  const rows = visibleRows(skeleton, folded, search);
  const focused = rows.some(({ joint }) => joint === current) ? current : rows[0]?.joint;
  const selected = selectedJoint.value;
  const together = new Set(selectedJoints(session));
  // The list is the legend of the weights: what is under the pointer in one of them, lights in all.
  const swatches = showWeights.value ? jointColorsOf(skeleton).bytes : null;
  const lit = swatches ? (hoveredOf(editor.session)?.joint ?? null) : null;
  const light = (joint: number | null): void => {
    const actorId = selectedActorId.value;
    if (!swatches || actorId === null) return;
    hoveredLimb.value = joint === null ? null : { actorId, joint, bone: null };
  };

  // A joint that was selected elsewhere is scrolled into view.
  useEffect(() => {
    if (selected === null) return;
    setFolded((old) => {
      const hidden = ancestorsOf(skeleton, selected).filter((joint) => old.has(joint));
      return hidden.length === 0 ? old : new Set([...old].filter((each) => !hidden.includes(each)));
    });
    setCurrent(selected);
  }, [selected, skeleton]);

  useEffect(() => {
    if (selected === null) return;
    list.current?.querySelector(`[data-joint="${selected}"]`)?.scrollIntoView({ block: 'nearest' });
  }, [selected, folded]);

  const fold = (joint: number, closed: boolean): void =>
    setFolded((old) => {
      const next = new Set(old);
      if (closed) next.add(joint);
      else next.delete(joint);
      return next;
    });
  const moveTo = (joint: number | undefined): void => {
    if (joint === undefined) return;
    setCurrent(joint);
    list.current?.querySelector<HTMLElement>(`[data-joint="${joint}"]`)?.focus();
  };
  /**
   * Whether a press brought the focus, not a key. Whoever presses a row goes on in the view, so that
   * letters are the page's keys until a key of the list is used.
   */
  const isPressed = (): boolean => list.current?.hasAttribute(pressedAttribute) === true;
  const setPressed = (isPressed: boolean): void => {
    list.current?.toggleAttribute(pressedAttribute, isPressed);
  };
  /** Moves to a row and takes it into the selection, or, going back, the last one out of it. */
  const extendTo = (joint: number | undefined, from: number): void => {
    if (joint === undefined) return;
    const present = selectedJoints(session);
    const isBack = present.includes(joint) && present.includes(from);
    if (isBack) toggleJoint(session, from);
    else selectJoints(session, [...new Set([joint, from, ...present])]);
    moveTo(joint);
  };
  const onKey = (event: KeyboardEvent, row: TreeRow): void => {
    const index = rows.findIndex(({ joint }) => joint === row.joint);
    const { key, shiftKey, altKey } = event;
    if (event.ctrlKey || event.metaKey) return;
    // These keys turn what is selected, so the row that has the focus is selected first.
    if (altKey) {
      if (key.startsWith('Arrow') && !selectedJoints(session).includes(row.joint))
        selectJoint(session, row.joint);
      return;
    }
    const isBlank = key === ' ' && !typeAhead.current.isTyping(event.timeStamp);
    const isLetter = Array.from(key).length === 1 && !isBlank;
    if (isLetter && isPressed()) return;
    setPressed(false);
    if (isLetter) {
      event.preventDefault();
      const names = rows.map(({ joint }) => nameOf(joint));
      moveTo(rows[typeAhead.current.find(names, index, key, event.timeStamp)]?.joint);
      return;
    }
    const step = key === 'ArrowDown' ? 1 : key === 'ArrowUp' ? -1 : 0;
    if (shiftKey && step !== 0) {
      event.preventDefault();
      extendTo(rows[index + step]?.joint, row.joint);
      return;
    }
    const actions: Record<string, () => void> = {
      ArrowDown: () => moveTo(rows[index + 1]?.joint),
      ArrowUp: () => moveTo(rows[index - 1]?.joint),
      Home: () => moveTo(rows[0]?.joint),
      End: () => moveTo(rows.at(-1)?.joint),
      ArrowRight: () => {
        if (row.isFolded) fold(row.joint, false);
        else if (row.hasChildren) moveTo(rows[index + 1]?.joint);
      },
      ArrowLeft: () => {
        if (row.hasChildren && !row.isFolded) fold(row.joint, true);
        else moveTo(skeleton.parents[row.joint]);
      },
      ' ': () => selectJoint(session, row.joint),
      // The focus stays, so that keys turn the joint; a second time it goes to the sliders.
      Enter: () => {
        if (selectedJoint.value === row.joint) editor.editJoint(row.joint);
        else selectJoint(session, row.joint);
      },
    };
    const action = actions[key];
    if (!action) return;
    event.preventDefault();
    action();
  };

  const nameOf = (joint: number): string =>
    `${skeleton.names[joint]!} ${skeleton.englishNames?.[joint] ?? ''}`.trim();
  const onClick = (event: MouseEvent, joint: number): void => {
    const isOneMore = event.shiftKey || event.ctrlKey || event.metaKey;
    if (isOneMore || session.selectsSeveral.value) toggleJoint(session, joint);
    else selectJoint(session, joint);
  };

  return (
    <section class="joints-panel" aria-labelledby="joints-title">
      <h2 id="joints-title">Joints ({skeleton.jointCount})</h2>
      <input
        type="search"
        placeholder="Search joints"
        aria-label="Search joints"
        value={search}
        onInput={({ currentTarget }) => setSearch(currentTarget.value)}
      />
      <ul
        role="tree"
        aria-multiselectable="true"
        aria-label="Joints"
        ref={list}
        class={lit === null ? '' : 'some-lit'}
        onPointerDown={() => setPressed(true)}
        onFocusOut={({ relatedTarget }) => {
          const isWithin = relatedTarget instanceof Node && list.current?.contains(relatedTarget);
          if (!isWithin) setPressed(false);
        }}
      >
        {rows.map((row) => (
          <li
            key={row.joint}
            role="treeitem"
            data-joint={row.joint}
            class={row.joint === lit ? 'lit' : ''}
            tabIndex={row.joint === focused ? 0 : -1}
            aria-level={row.level}
            aria-selected={together.has(row.joint)}
            {...(row.hasChildren ? { 'aria-expanded': !row.isFolded } : {})}
            style={{ paddingInlineStart: `${(row.level - 1) * 9 + 4}px` }}
            onFocus={() => {
              setCurrent(row.joint);
              light(row.joint);
            }}
            onBlur={() => light(null)}
            onPointerEnter={() => light(row.joint)}
            onPointerLeave={() => light(null)}
            onClick={(event) => onClick(event, row.joint)}
            onDblClick={() => editor.editJoint(row.joint)}
            onKeyDown={(event) => onKey(event, row)}
          >
            <span
              class="fold"
              aria-hidden="true"
              onClick={(event) => {
                if (!row.hasChildren) return;
                event.stopPropagation();
                fold(row.joint, !row.isFolded);
              }}
            >
              {row.hasChildren ? (row.isFolded ? '▸' : '▾') : ''}
            </span>
            {swatches && (
              <span
                class="swatch"
                aria-hidden="true"
                style={{ background: cssColor(swatches.subarray(row.joint * 3)) }}
              />
            )}
            {skeleton.names[row.joint]}
            {skeleton.englishNames?.[row.joint] && (
              <span class="english">{skeleton.englishNames[row.joint]}</span>
            )}
          </li>
        ))}
      </ul>
      {rows.length === 0 && <p class="hint">No joint has “{search}” in its name.</p>}
    </section>
  );
}
