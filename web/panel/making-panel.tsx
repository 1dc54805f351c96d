/** The place of the room maker, which is fetched when it is opened for the first time. */
import type { FunctionComponent } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import type { PackedPlan } from '../document/made-room.ts';
import { words } from '../language/language.ts';

type RoomMaker = FunctionComponent<{ plan: PackedPlan | null }>;

export function MakingPanel({ plan }: { plan: PackedPlan | null }) {
  const app = useApp();
  const [Maker, setMaker] = useState<RoomMaker | null>(null);
  useEffect(() => {
    import('./room-maker/room-maker.tsx').then(
      ({ RoomMaker: loaded }) => setMaker(() => loaded),
      () => {
        app.store.say('error', words.value.maker.notLoaded);
        void app.opening.endMaking();
      },
    );
  }, []);
  return Maker ? (
    <Maker plan={plan} />
  ) : (
    <aside class="panel maker" aria-label={words.value.maker.name} aria-busy="true" />
  );
}
