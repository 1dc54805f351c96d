#include "core/scene/luminaire.h"

namespace fiatlux {

Luminaire luminaireOf(const Site& site) {
  Luminaire luminaire;
  luminaire.position = site.position;
  luminaire.normal = site.normal;
  luminaire.axis = site.axis;
  luminaire.width = luminaire.height = site.size;
  luminaire.flux = 1;
  return luminaire;
}

}  // namespace fiatlux
