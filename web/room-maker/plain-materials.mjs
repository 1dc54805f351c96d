// Materials of one colour that furniture, doors and windows are made of, in the sample rooms and in made ones.
export const plainMaterials = {
  'white lacquer': { colour: '#efece6', reflectance: 0.68, roughness: 0.5 },
  'grey lacquer': { colour: '#a9adb0', reflectance: 0.4, roughness: 0.5 },
  'dark steel': { colour: '#3c3f43', reflectance: 0.06, roughness: 0.45, metallic: 0.2 },
  'pale steel': { colour: '#c3c6c8', reflectance: 0.5, roughness: 0.4, metallic: 0.2 },
  'black plastic': { colour: '#26282b', reflectance: 0.04, roughness: 0.6 },
  screen: { colour: '#11161d', reflectance: 0.03, roughness: 0.25 },
  glass: { colour: '#1c2a3a', reflectance: 0.06, roughness: 0.1 },
  leaf: { colour: '#4f7d3c', reflectance: 0.17, roughness: 0.7 },
  'dark leaf': { colour: '#37663b', reflectance: 0.11, roughness: 0.7 },
  stem: { colour: '#6d5a3c', reflectance: 0.11 },
  earth: { colour: '#4a3b2c', reflectance: 0.06 },
  pot: { colour: '#d8d3c8', reflectance: 0.55, roughness: 0.7 },
  'measuring plane': { colour: '#7fb2ff', alpha: 0 },
};
