/**
 * The keyword of the text that a saved PNG carries: the JSON of its scene. The user's own files are
 * never stored in pictures, because pictures get shared; the scene only names them.
 */
export const pictureKeyword = 'Sinew';
