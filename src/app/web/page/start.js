// Says why the page does not start, where a browser will not run its modules.
(function () {
    var one_file = document.getElementById("file module.wasm"), status = document.getElementById("verdict");
    if (location.protocol === "file:" && !one_file) {
        document.body.className = "stopped";
        status.innerHTML = "A browser opens this page only from a web server. Open <a href=\"../twinlight.html\">twinlight.html</a> instead: the same " +
            "page as one file, which needs no server. <code>make web</code> writes it.";
    } else if (typeof DecompressionStream === "undefined" || typeof WebAssembly === "undefined") {
        document.body.className = "stopped";
        status.textContent = "This browser is too old for the page. Use Chromium 123, Firefox 120, Safari 17.5, or a later version.";
    }
})();
