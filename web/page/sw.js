// Keeps the page for times without a network: its files of this version, fetched once, and nothing else.

const VERSION = "development";
const FILES = [
  "./",
  "index.html",
  "style.css",
  "icon.svg",
  "main.js",
  "engine.js",
  "worker.js",
  "dom.js",
  "format.js",
  "colors.js",
  "drive.js",
  "chart.js",
  "controls.js",
  "readouts.js",
  "share.js",
  "belt.js",
  "shift.js",
  "whole.js",
  "tune.js",
  "gx9.toml",
  "sheave.wasm",
];

self.addEventListener("install", (event) => {
  const keep = async () => {
    const cache = await caches.open(VERSION);
    await cache.addAll(FILES.map((file) => new Request(file, { cache: "reload" })));
    await self.skipWaiting();
  };
  event.waitUntil(keep());
});

self.addEventListener("activate", (event) => {
  const tidy = async () => {
    for (const name of await caches.keys()) if (name !== VERSION) await caches.delete(name);
    await self.clients.claim();
  };
  event.waitUntil(tidy());
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || new URL(request.url).origin !== self.location.origin) return;
  event.respondWith(
    caches.match(request, { cacheName: VERSION, ignoreSearch: true }).then((kept) => kept ?? fetch(request)),
  );
});
