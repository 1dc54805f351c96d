/** What tests of the page ask of the site's luminaires. */
export const luminaires: readonly {
  readonly title: string;
  readonly translations: { readonly de: { readonly title: string } };
}[];
