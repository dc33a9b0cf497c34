/// The judge's evidence as plain numbers, and the frames that it judged by.
#pragma once

#include "compare/rendered_frame.h"
#include "zproof/data.h"

namespace zproof::api {

Finding plain(const zproof::Finding& finding);

RenderedFrame candidate_of(const Verdict::Data& data);
RenderedFrame reference_of(const Verdict::Data& data);

}  // namespace zproof::api
