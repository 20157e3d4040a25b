import { expect } from '@playwright/test';
import {
  capture,
  choose,
  controlRow,
  getPose,
  openApp,
  openJoint,
  openSmallView,
  setPose,
} from './support/app.ts';
import { cameraOf } from './support/controls.ts';
import { expectPicture } from './support/pictures.ts';
import { coarse, sharedPage, test } from './support/test.ts';

test.use({ ...coarse, viewport: { width: 1000, height: 460 } });
const page = sharedPage(async (page) => {
  await openApp(page, 'workspace=mannequin');
  await expect(controlRow(page, 'Dragging').locator('option:checked')).toHaveText('as in CS354');
  await choose(page, 'Dragging', 'follows the pointer');
});

const label = () => page().locator('.lit-bone');
const canvas = () => page().locator('canvas.scene');
const row = (name: string) => controlRow(page(), name).locator('input');

interface Place {
  readonly x: number;
  readonly y: number;
}

/** A point of the view, as fractions of its width and height. */
async function placeAt(across: number, down: number): Promise<Place> {
  const { x, y, width, height } = (await canvas().boundingBox())!;
  return { x: x + across * width, y: y + down * height };
}

async function placesAlong(down: number): Promise<Place[]> {
  const steps = Array.from({ length: 30 }, (_, step) => 0.15 + step * 0.015);
  return Promise.all(steps.map((across) => placeAt(across, down)));
}

const found = new Map<string, Place>();

/** Searches for a bone from left to right, once per camera, and leaves the pointer on it. */
async function findBone(name: string, down: number): Promise<Place> {
  const known = found.get(name);
  const places = known ? [known] : await placesAlong(down);
  for (const place of places) {
    await page().mouse.move(place.x, place.y);
    const text = (await label().allTextContents()).join();
    if (!text.startsWith(name)) continue;
    found.set(name, place);
    return place;
  }
  throw new Error(`no ${name} is lit at ${down} of the height`);
}

async function drag(from: Place, by: readonly [number, number], steps = 2): Promise<Place> {
  await page().mouse.move(from.x, from.y);
  await page().mouse.down();
  const to = { x: from.x + by[0], y: from.y + by[1] };
  await page().mouse.move(to.x, to.y, { steps });
  return to;
}

const thigh = () => findBone('Right upper leg', 0.6);
const jointsChangedFrom = async (before: Awaited<ReturnType<typeof getPose>>) => {
  const after = await getPose(page());
  const names = new Set([...Object.keys(before.joints!), ...Object.keys(after.joints!)]);
  return [...names].filter(
    (name) => JSON.stringify(before.joints![name]) !== JSON.stringify(after.joints![name]),
  );
};

test('the bone under the pointer is highlighted, with its name and chain; a click selects its joint', async () => {
  const place = await thigh();
  await expect(label()).toHaveText('Right upper leg → Right lower legRoot › Hips › Right hip');
  await page().mouse.click(place.x, place.y);
  await expect(page().getByRole('treeitem', { selected: true })).toHaveText(/Right upper leg/);
  const corner = await placeAt(0.02, 0.02);
  await page().mouse.move(corner.x, corner.y);
  await expect(label()).toHaveCount(0);
});

test('outside of bone mode a drag on a bone moves the camera', async () => {
  const [pose, camera] = [await getPose(page()), await cameraOf(page())];
  await drag(await thigh(), [60, 20]);
  await page().mouse.up();
  expect(await getPose(page())).toEqual(pose);
  expect(await cameraOf(page())).not.toEqual(camera);
  await page().keyboard.press('Space');
  expect(await cameraOf(page())).toEqual(camera);
});

test('in bone mode a drag turns the bone, which stays under the pointer; dragging back, Escape and undo restore the pose', async () => {
  await canvas().focus();
  await page().keyboard.press('m');
  await expect(row('Bone mode (m)')).toBeChecked();
  const camera = await cameraOf(page());
  const pose = await getPose(page());
  const from = await thigh();
  const to = await drag(from, [-26, -12]);
  expect(await jointsChangedFrom(pose)).toEqual(['Right upper leg']);
  expect(await cameraOf(page()), 'the camera rests').toEqual(camera);
  await page().mouse.move(from.x, from.y, { steps: 2 });
  expect(await getPose(page()), 'the way back is the pose of the start').toEqual(pose);
  await page().mouse.move(to.x, to.y);
  await page().keyboard.press('Escape');
  expect(await getPose(page()), 'canceled').toEqual(pose);
  await page().mouse.move(to.x + 20, to.y);
  expect(await getPose(page()), 'and stays so until the button is let go').toEqual(pose);
  await page().mouse.up();

  const end = await drag(from, [-26, -12]);
  await page().mouse.up();
  await page().mouse.move(end.x, end.y + 1);
  await expect(label(), 'it is still under the pointer').toContainText('Right upper leg');
  await page().keyboard.press('Control+z');
  expect(await getPose(page()), 'one step of undo').toEqual(pose);
});

test('in bone mode a drag beside the bones still moves the camera', async () => {
  const [pose, camera] = [await getPose(page()), await cameraOf(page())];
  await drag(await placeAt(0.06, 0.75), [40, 0]);
  await page().mouse.up();
  expect(await getPose(page())).toEqual(pose);
  expect(await cameraOf(page())).not.toEqual(camera);
  await page().keyboard.press('Space');
});

test('the arrow keys and Alt+drag roll the bone, and its far end stays', async () => {
  const before = await getPose(page());
  const place = await thigh();
  await page().keyboard.press('ArrowLeft');
  expect(await jointsChangedFrom(before)).toEqual(['Right upper leg']);
  await page().keyboard.press('ArrowRight');
  const after = await getPose(page());
  after.joints!['Right upper leg']!.forEach((angle, i) => {
    expect(angle).toBeCloseTo(before.joints!['Right upper leg']?.[i] ?? 0, 9);
  });
  await page().keyboard.down('Alt');
  await drag(place, [0, 40]);
  await page().mouse.up();
  await page().keyboard.up('Alt');
  expect(await jointsChangedFrom(after)).toEqual(['Right upper leg']);
  await page().mouse.move(place.x, place.y);
  await expect(label(), 'the bone is where it was').toContainText('Right upper leg');
  await page().getByRole('button', { name: 'Reset all' }).click();
});

test('the method of the course’s program is a setting, and gives another pose', async () => {
  const pose = await getPose(page());
  const place = await thigh();
  await drag(place, [-24, 0]);
  const followed = await getPose(page());
  await page().keyboard.press('Escape');
  await page().mouse.up();
  await choose(page(), 'Dragging', 'as in CS354');
  await drag(place, [-24, 0]);
  const course = await getPose(page());
  expect(await jointsChangedFrom(pose)).toEqual(['Right upper leg']);
  expect(course).not.toEqual(followed);
  await page().mouse.move(place.x, place.y, { steps: 2 });
  expect(await getPose(page())).toEqual(pose);
  await page().mouse.up();
  await choose(page(), 'Dragging', 'follows the pointer');
});

test('with one angle active, dragging its limb changes only that angle', async () => {
  const place = await thigh();
  const { field } = await openJoint(page(), 'Right upper leg', 'Z');
  await field.fill('0.01');
  await field.press('Enter');
  const before = await getPose(page());
  await drag(place, [-30, 0]);
  await page().mouse.up();
  const after = await getPose(page());
  const [x, y, z] = before.joints!['Right upper leg']!;
  const [afterX, afterY, afterZ] = after.joints!['Right upper leg']!;
  expect([afterX, afterY]).toEqual([x, y]);
  expect(Math.abs(afterZ - z)).toBeGreaterThan(0.05);
  await page().keyboard.press('Escape');
  await expect(page().locator('.active-dof')).toHaveCount(0);
});

test('Shift+R resets only the selected joint', async () => {
  await setPose(page(), { joints: { Head: [0.2, 0, 0], Neck: [0.1, 0, 0] } });
  await page().getByRole('treeitem', { name: 'Head', exact: true }).click();
  await canvas().focus();
  await page().keyboard.press('Shift+R');
  expect(await getPose(page())).toEqual({ joints: { Neck: [0.1, 0, 0] } });
  await page().getByRole('button', { name: 'Reset all' }).click();
});

test('through an opaque skin, a drag grabs the joint that the skin follows', async () => {
  await canvas().focus();
  await page().keyboard.press('t');
  const place = await findBone('Right lower leg', 0.74);
  const pose = await getPose(page());
  await drag(place, [-20, -10]);
  await page().mouse.up();
  expect(await jointsChangedFrom(pose)).toEqual(['Right lower leg']);
  await page().keyboard.press('t');
  await page().getByRole('button', { name: 'Reset all' }).click();
});

test('in first person a drag looks around, letters and arrows walk, and c leaves', async () => {
  await page().keyboard.press('m');
  await canvas().focus();
  const { distance } = await cameraOf(page());
  await page().keyboard.press('c');
  await expect(row('First person (c)')).toBeChecked();
  const picture = await capture(page());
  await page().keyboard.press('w');
  await page().keyboard.press('d');
  await page().keyboard.press('ArrowUp');
  expect((await capture(page())).equals(picture)).toBe(false);
  expect(await cameraOf(page()), 'walking turns nothing').toMatchObject({ distance });
  await drag(await placeAt(0.1, 0.3), [50, 0]);
  await page().mouse.up();
  await page().keyboard.press('c');
  await page().keyboard.press('Space');
});

test.describe('touch', () => {
  test.use({ hasTouch: true });

  test('the first touch highlights a bone, a drag turns it, and a second finger cancels', async ({
    page: own,
  }) => {
    await openApp(own, 'workspace=mannequin');
    await own.getByRole('button', { name: 'Bone mode' }).tap();
    const pose = await getPose(own);
    const box = (await own.locator('canvas.scene').boundingBox())!;
    const fire = (type: string, id: number, x: number, y: number) =>
      own.locator('canvas.scene').dispatchEvent(type, {
        pointerId: id,
        pointerType: 'touch',
        clientX: x,
        clientY: y,
        button: 0,
        isPrimary: id === 1,
        bubbles: true,
      });
    await own.evaluate(() => {
      // Only a real pointer can be captured, and these events are synthetic.
      Element.prototype.setPointerCapture = () => undefined;
    });
    const y = box.y + box.height * 0.6;
    let x = 0;
    for (let across = 0.25; across < 0.6; across += 0.02) {
      x = box.x + across * box.width;
      await fire('pointerdown', 1, x, y);
      const text = (await own.locator('.lit-bone').allTextContents()).join();
      if (text.startsWith('Right upper leg')) break;
      await fire('pointerup', 1, x, y);
    }
    await expect(own.locator('.lit-bone')).toContainText('Right upper leg');
    await fire('pointermove', 1, x + 30, y - 30);
    const turned = await getPose(own);
    expect(turned.joints!['Right upper leg']).not.toEqual(pose.joints!['Right upper leg']);
    await fire('pointerdown', 2, x + 90, y);
    expect(await getPose(own)).toEqual(pose);
    await fire('pointermove', 2, x + 120, y);
    expect(await getPose(own)).toEqual(pose);
  });
});

test.describe('pictures', () => {
  test.use({ deviceScaleFactor: 1 });
  const view = sharedPage((page) => openSmallView(page, 'workspace=mannequin'));
  const size = { width: 640, height: 480 };

  test('a translucent skin shows the bones inside', async () => {
    expectPicture('mannequin', await capture(view(), 'png', size));
    await view().keyboard.press('a');
    expectPicture('mannequin-frames', await capture(view(), 'png', size));
    await view().keyboard.press('a');
  });

  test('a highlighted bone is drawn with its cylinder', async () => {
    const box = (await view().locator('canvas.scene').boundingBox())!;
    for (let across = 0.32; across < 0.6; across += 0.015) {
      await view().mouse.move(box.x + across * box.width, box.y + box.height * 0.6);
      const text = (await view().locator('.lit-bone').allTextContents()).join();
      if (text.startsWith('Right upper leg')) break;
    }
    expectPicture('mannequin-lit', await capture(view(), 'png', size));
  });
});
