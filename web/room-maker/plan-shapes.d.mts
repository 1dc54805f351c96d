import type { Point } from './room-plan.mjs';

export type ShapeName = 'rectangle' | 'L' | 'U' | 'T';
export const outlines: Readonly<
  Record<ShapeName, (width: number, depth: number, cutWidth?: number, cutDepth?: number) => Point[]>
>;
export const sizeBounds: Readonly<Record<'least' | 'longest' | 'tallest', number>>; // m

export type SizeFault = 'unread' | 'outside';
type Size = Readonly<Record<'width' | 'depth' | 'height', number>>; // m
export function readSize(text: string): { size: Size; fault?: never } | { size?: never; fault: SizeFault };
