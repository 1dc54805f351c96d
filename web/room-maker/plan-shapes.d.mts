import type { Point } from './room-plan.mjs';

export type ShapeName = 'rectangle' | 'L' | 'U' | 'T';
export const outlines: Readonly<
  Record<ShapeName, (width: number, depth: number, cutWidth?: number, cutDepth?: number) => Point[]>
>;
export function readSize(text: string): { width: number; depth: number; height: number } | null; // m
