/** The picture of a room or experiment (scripts/pictures.mjs), in front of the ground of the system's colour scheme. */

interface Props {
  readonly id: string;
  readonly class: string;
  readonly lazy?: boolean;
  readonly onError: () => void;
}

export function RoomPicture({ id, lazy, onError, ...props }: Props) {
  return (
    <picture>
      <source srcset={`./thumbnails/light/${id}.jpg`} media="(prefers-color-scheme: light)" />
      <img
        class={props.class}
        src={`./thumbnails/dark/${id}.jpg`}
        alt=""
        {...(lazy && { loading: 'lazy' })}
        width={240}
        height={150}
        onError={onError}
      />
    </picture>
  );
}
