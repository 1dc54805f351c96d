import type { Point } from './room-plan.mjs';

type Polygon = readonly Point[];
export function distance(a: Point, b: Point): number;
export function signedArea(polygon: Polygon): number;
export function contains(polygon: Polygon, point: Point): boolean;
export function distanceToOutline(polygon: Polygon, point: Point): number;
export function isSimple(polygon: Polygon): boolean;
export function holds(a: Polygon, b: Polygon, clearance?: number): boolean;
export function areApart(a: Polygon, b: Polygon, clearance?: number): boolean;
export function inset(polygon: Polygon, by: number): Point[] | null;
export function triangles(polygon: Polygon, holes?: readonly Polygon[]): Point[][];
export function rotated(points: Polygon, degrees: number): Point[];
