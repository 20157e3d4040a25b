/**
 * A `.skel` with the course's own topology (18 joints; 1, 3, 12 and 15 are children of the root)
 * and round numbers.
 */
export const courseSkel = `0 5 0 -1
0 0 0 0
0 -1 0 1
0 0 0 0
0 -0.5 0 2
-0.5 0 0 4
0 -2 0 5
0 -2 0 6
0 -0.5 0 2
0.5 0 0 8
0 -2 0 9
0 -2 0 10
0 0 0 0
-1 0 0 12
-1 0 0 13
0 0 0 0
1 0 0 15
1 0 0 16
`;
