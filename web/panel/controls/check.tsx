/** Something that is on or off, with its word. */
interface Props {
  readonly label: string;
  readonly checked: boolean;
  readonly set: (on: boolean) => void;
}

export function Check({ label, checked, set }: Props) {
  return (
    <label class="check">
      <input type="checkbox" checked={checked} onChange={(event) => set(event.currentTarget.checked)} />
      <span>{label}</span>
    </label>
  );
}
