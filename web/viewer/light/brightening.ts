/** How many times the light of its patches a place near a contact may have: beyond, their mean is mostly noise. */
export const mostBrightening = 6;
