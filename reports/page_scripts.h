/// The scripts that pages carry inside, built from reports/viewer/ and committed in reports/viewer/dist/.
#pragma once

#include <string>
#include <string_view>

namespace zproof {

/// A script as it stands in a page. The page's content security policy admits it by its digest, and no
/// other but those it may load.
struct PageScript {
    std::string_view text;
    std::string_view sha256;    ///< of the text, base64
    bool loads_others = false;  ///< from files beside the page?
};

/// Makes `<table class="sortable">` sortable and links `<figure data-linked="GROUP">` crops
/// (reports/viewer/src/sortable.ts, crops.ts); for any page.
PageScript table_script();

/// The viewer of report.html; does what table_script() does as well.
PageScript viewer_script();
std::string_view viewer_style();

/// The script in its element, for the end of the body.
std::string script_element(const PageScript& script);

/// A policy under which a page may show its own styles and data: pictures and run this one script, and under
/// which nothing reaches another place. 'self' is where the page comes from; `file:` says it of a page from
/// disk.
std::string content_policy(const PageScript& script);

}  // namespace zproof
