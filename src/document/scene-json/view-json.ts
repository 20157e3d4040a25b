import { defaultLimits } from '../../core/limits.ts';
import { weightViews } from '../../skinning/weights/views.ts';
import { plainView, type SavedSignals, type ViewState } from '../view-state.ts';
import { cameraJson } from './camera-json.ts';
import { comparisonJson, formerComparison } from './comparison-json.ts';
import { type Codec, flag, index, numberWithin, oneOf, orNull, text } from './codec.ts';
import { type Codecs, readFields, writeFields } from './fields.ts';

const { coordinate } = defaultLimits;

const seconds = numberWithin(-coordinate, coordinate);

const signals: Codecs<SavedSignals> = {
  showSkin: flag,
  showSkeleton: flag,
  skeletonStyle: oneOf(['sticks', 'boxes', 'both', 'lines']),
  showAxes: flag,
  translucent: flag,
  showTextures: flag,
  showWeights: flag,
  weightView: oneOf(weightViews.map(({ id }) => id)),
  unlitWeights: flag,
  showNormals: flag,
  comparison: orNull(comparisonJson),
  shownShot: orNull(index),
  showThirds: flag,
  posesBy: oneOf(['selection', 'mode']),
  clipIndex: index,
  clipTime: seconds,
  playMode: oneOf(['once', 'loop', 'ping-pong', 'go on']),
  playSpeed: numberWithin(-1e6, 1e6),
};

const rows: Codecs<ViewState> = {
  camera: cameraJson,
  workspace: text,
  selected: orNull(index),
  joint: orNull(index),
  signals: {
    write: (value) => writeFields(signals, value, plainView.signals),
    read(json) {
      const read = readFields(signals, json, [formerComparison.name]);
      const comparison = read && formerComparison.read(json);
      return read && { ...plainView.signals, ...comparison, ...read };
    },
  },
};

/** How the scene is viewed: time, camera and switches. */
export const viewJson: Codec<ViewState> = {
  write: (view) => writeFields(rows, view, plainView),
  read(json) {
    const read = readFields(rows, json);
    return read && { ...plainView, ...read };
  },
};
