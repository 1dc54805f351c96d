/** The worker: one builder. */
import { BuilderDriver } from './driver.ts';
import type { ToBuilder } from './protocol.ts';

declare const self: DedicatedWorkerGlobalScope;

const driver = new BuilderDriver((message, transfer) => self.postMessage(message, transfer));

self.onmessage = ({ data }: MessageEvent<ToBuilder>) => void driver.receive(data);
