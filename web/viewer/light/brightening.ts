/** How many times the light of its patches a place near a contact may have: beyond, their mean is mostly noise. */
export const mostBrightening = 6;

/** And the least: what is in every luminaire's shadow still has the light that comes from all round. */
export const leastDarkening = 0.05;
