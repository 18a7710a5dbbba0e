#include "lab/page/page_bundle.h"

namespace scatter::lab {

PageBundle pageBundle() {
  return {};
}

}  // namespace scatter::lab
