#include "zproof/zproof.h"

namespace zproof::api {

std::string_view version() { return ZPROOF_VERSION; }

}  // namespace zproof::api
