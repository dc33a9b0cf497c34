#include "reports/page_scripts.h"

// ZPROOF_VIEWER_FOLDER is reports/viewer/dist; the assembler reads the files.
asm(".section .rodata\n"
    "zproof_viewer_js: .incbin \"" ZPROOF_VIEWER_FOLDER
    "/viewer.js\"\nzproof_viewer_js_end:\n"
    "zproof_viewer_sha256: .incbin \"" ZPROOF_VIEWER_FOLDER
    "/viewer.js.sha256\"\nzproof_viewer_sha256_end:\n"
    "zproof_viewer_css: .incbin \"" ZPROOF_VIEWER_FOLDER
    "/viewer.css\"\nzproof_viewer_css_end:\n"
    "zproof_page_js: .incbin \"" ZPROOF_VIEWER_FOLDER
    "/page.js\"\nzproof_page_js_end:\n"
    "zproof_page_sha256: .incbin \"" ZPROOF_VIEWER_FOLDER
    "/page.js.sha256\"\nzproof_page_sha256_end:\n"
    ".text\n");

extern "C" {
extern const char zproof_viewer_js[], zproof_viewer_js_end[];
extern const char zproof_viewer_sha256[], zproof_viewer_sha256_end[];
extern const char zproof_viewer_css[], zproof_viewer_css_end[];
extern const char zproof_page_js[], zproof_page_js_end[];
extern const char zproof_page_sha256[], zproof_page_sha256_end[];
}

namespace zproof {

namespace {

std::string_view between(const char* begin, const char* end) { return {begin, std::size_t(end - begin)}; }

}  // namespace

PageScript table_script() {
    return {between(zproof_page_js, zproof_page_js_end), between(zproof_page_sha256, zproof_page_sha256_end)};
}

PageScript viewer_script() {
    return {between(zproof_viewer_js, zproof_viewer_js_end),
            between(zproof_viewer_sha256, zproof_viewer_sha256_end)};
}

std::string_view viewer_style() { return between(zproof_viewer_css, zproof_viewer_css_end); }

std::string script_element(const PageScript& script) {
    return "<script>" + std::string(script.text) + "</script>\n";
}

std::string content_policy(const PageScript& script) {
    return "default-src 'none'; script-src 'sha256-" + std::string(script.sha256) + "'" +
           (script.loads_others ? " 'self' file:" : "") + "; style-src 'unsafe-inline'; img-src data: blob:";
}

}  // namespace zproof
