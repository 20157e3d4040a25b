import { useEffect, useRef } from 'preact/hooks';
import { loadPart } from '../../../core/failure.ts';
import type { Actor } from '../../../document/scene.ts';
import { attempt } from '../../attempt.ts';
import type { Editor } from '../../editor.ts';
import type { LibraryPose } from '../../pose-library.ts';

interface PoseThumbnailProperties {
  readonly editor: Editor;
  readonly actor: Actor;
  readonly pose: LibraryPose;
}

/** A picture of a pose: made in advance where it comes with the character, or drawn by the view. */
export function PoseThumbnail({ editor, actor, pose }: PoseThumbnailProperties) {
  const list = editor.bundled.value.find(({ id }) => isOf(actor, id))?.poses;
  if (pose.place === undefined || list === undefined) {
    return <DrawnThumbnail key={pose.key} {...{ editor, actor, pose }} />;
  }
  const picture = `data/${list.replace(/\.json$/, '.webp')}`;
  return (
    <i
      class="thumbnail"
      aria-hidden="true"
      ref={(element) => {
        if (!element) return;
        // The page's policy allows styles through their objects alone.
        element.style.backgroundImage = `url(${picture})`;
        element.style.backgroundPosition = `0 ${pose.place! * 100}%`;
      }}
    />
  );
}

function isOf({ source }: Actor, id: string): boolean {
  return source.kind === 'bundled' && source.id === id;
}

/** Drawn when it is in view, the character stands still and nothing is dragged. */
function DrawnThumbnail({ editor, actor, pose: { pose } }: PoseThumbnailProperties) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const { character, look, method } = actor;
  useEffect(() => {
    const element = canvas.current!;
    let isOver = false;
    const draw = async (): Promise<void> => {
      const { drawThumbnail } = await loadPart(import('../../draw-thumbnail.ts'));
      if (!isOver) await drawThumbnail(editor, actor, pose, element);
    };
    const observer = new IntersectionObserver((entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
      observer.disconnect();
      attempt(editor, draw());
    });
    observer.observe(element);
    return () => {
      isOver = true;
      observer.disconnect();
    };
  }, [editor, character, look, method, pose]);
  return <canvas ref={canvas} class="thumbnail" width="1" height="1" aria-hidden="true" />;
}
