// Keeps sheets that were opened, and the program that checks them, for when there is no network.
self.addEventListener('install', () => self.skipWaiting());
self.addEventListener('activate', (event) => event.waitUntil(self.clients.claim()));
self.addEventListener('fetch', (event) => {
  if (event.request.method !== 'GET') return;
  const fresh = async () => {
    const response = await fetch(event.request);
    if (response.ok) (await caches.open('slipstick')).put(event.request, response.clone());
    return response;
  };
  event.respondWith(fresh().catch(async () => (await caches.match(event.request, { ignoreSearch: true })) ?? Response.error()));
});
